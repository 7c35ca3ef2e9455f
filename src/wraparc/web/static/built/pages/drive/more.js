import{a,b}from"../../chunk-BUTA24C7.js";import"../../chunk-67AWL4ZT.js";import"../../chunk-A4SERXLY.js";export{b as moreInputs,a as pulleyName};
