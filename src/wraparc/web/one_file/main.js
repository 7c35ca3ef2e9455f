// The calculator as one file: the pages of the server, with what it answers answered here.
import "../static/main.js";
