// What presses on several drives make of documents, and what they name as removed.
import { readFileSync } from "node:fs";

globalThis.document = { addEventListener() {}, documentElement: { classList: { add() {} } } };
const { app } = await import("../../src/wraparc/web/static/base/design.js");
const { lostParts } = await import("../../src/wraparc/web/static/base/lost_parts.js");
const { conveyorTrains, movedKeys, withDrive, withoutDrive } = await import(
  "../../src/wraparc/web/static/pages/train/convert.js"
);
const does = {
  add: (doc, arcs) => withDrive(doc, arcs ?? []),
  remove: (doc, i) => withoutDrive(doc, i),
  tensions: ({ conveyor, ...rest }, arcs) => ({
    ...rest,
    load_case: conveyorTrains({ conveyor, ...rest }, arcs),
  }),
};
const told = ({ doc, press, with: more }) => {
  const after = does[press](doc, more);
  return { doc: after, lost: lostParts(doc, after, movedKeys(doc)) };
};
const { form, cases } = JSON.parse(readFileSync(0, "utf-8"));
app.form = form;
process.stdout.write(JSON.stringify(cases.map(told)));
