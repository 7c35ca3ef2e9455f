import{a}from"../chunk-UXQ7CYVO.js";export{a as entry};
