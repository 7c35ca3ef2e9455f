import{a,b}from"../../chunk-YBXVHHIJ.js";export{b as moreInputs,a as pulleyName};
