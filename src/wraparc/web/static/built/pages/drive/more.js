import{a,b}from"../../chunk-BLAKVUQK.js";export{b as moreInputs,a as pulleyName};
