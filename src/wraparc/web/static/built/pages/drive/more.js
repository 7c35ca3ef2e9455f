import{a,b}from"../../chunk-PISZ2VS3.js";import"../../chunk-67AWL4ZT.js";export{b as moreInputs,a as pulleyName};
