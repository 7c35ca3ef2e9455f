import{a,b}from"../../chunk-ZCQSBRTR.js";import"../../chunk-67AWL4ZT.js";import"../../chunk-RLXXJ5FI.js";import"../../chunk-4Z3HTJIB.js";export{b as moreInputs,a as pulleyName};
