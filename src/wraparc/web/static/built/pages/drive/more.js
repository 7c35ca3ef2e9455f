import{a,b}from"../../chunk-JWTJFTHC.js";export{b as moreInputs,a as pulleyName};
