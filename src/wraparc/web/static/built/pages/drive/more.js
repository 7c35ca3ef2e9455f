import{a,b}from"../../chunk-XYLNT7V2.js";export{b as moreInputs,a as pulleyName};
