// Unpacks the scripts of the file and runs them: packed they are a third as large.
import { unpacked } from "./unpacked.js";

for (const id of ["solver", "program"]) {
  const script = document.createElement("script");
  script.textContent = await unpacked(`${id}-packed`);
  script.id = id;
  document.body.append(script);
}
