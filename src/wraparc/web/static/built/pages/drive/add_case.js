import{a,b}from"../../chunk-67AWL4ZT.js";export{a as addCase,b as firstOf};
