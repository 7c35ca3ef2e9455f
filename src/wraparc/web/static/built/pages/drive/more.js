import{a,b,c}from"../../chunk-Q6RRRF6Y.js";export{a as fromExample,c as moreInputs,b as pulleyName};
