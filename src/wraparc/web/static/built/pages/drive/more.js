import{a,b}from"../../chunk-JFAXGNCT.js";import"../../chunk-67AWL4ZT.js";import"../../chunk-A4SERXLY.js";import"../../chunk-4Z3HTJIB.js";export{b as moreInputs,a as pulleyName};
