import{a,b}from"../../chunk-4RX5I4BK.js";import"../../chunk-67AWL4ZT.js";export{b as moreInputs,a as pulleyName};
