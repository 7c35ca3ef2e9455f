// A drive put together in the page: read by the functions of the program, with the numeric form of
// its laws from the book that the server hands out.
import { known, read, told } from "../../documents.js";
import { alone, arcsOf, criteriaOf, givenOf, InputError, idleIn, weakKinds } from "../../reader.js";
import { numbersOf } from "./own.js";

/** @import { Assembled, Book, BookLagging, Design, Judging, Problem } from "../../types.d.ts" */

/** @typedef {Judging["cases"]} Served cases that the server has solved */

const HERE = "wraparc solve and wraparc serve do";
/** What a drive has that only the program itself solves; empty for a drive of the page.
 * @param {any} drive as read */
export function beyond(drive) {
  const uneven = drive.pulleys.find((/** @type {any} */ p) => p.across);
  if (uneven) return acrossOf(uneven);
  if (!drive.cases && drive.pulleys.length > 1)
    return `Pulleys that each give their tensions, without [train], are not solved here; ${HERE}.`;
  return "";
}
/** What is said of a pulley whose load is uneven across the width. @param {any} pulley */
const acrossOf = ({ name }) =>
  `The load across the width of pulley ${name} is not solved in this page, and there is no ` +
  "verdict without it. On the command line: wraparc solve FILE.";
/** A problem of what the page leaves to the program. @param {string} message @param {string} [at]
 * @returns {Problem} */
export const left = (message, at = "") => ({
  path: at,
  message,
  sentence: at ? `${at}: ${message}.` : message,
  beyond: true,
});
/** A document read by the functions of the program, or what is wrong with it, as it says so.
 * @param {any} doc @param {Book} book @returns {{found: any, problems: Problem[]}} */
export function readIn(doc, book) {
  known(book.catalogue);
  return read(doc);
}

/** Keys of a lagging that make its law another one. */
const LAW = ["law", "condition_factor", "slip_speed", "temperature"];
/** What the book has of the lagging of a pulley. @param {any} doc @param {number} i
 * @param {Book} book @returns {BookLagging | undefined} */
function entryOf(doc, i, book) {
  const given = doc.pulley[i].lagging;
  const name = given.preset ?? given;
  const own = doc.lagging?.[name];
  const other = own && JSON.stringify(own) !== JSON.stringify(book.own?.[name]);
  const law = LAW.some((key) => given[key] != null);
  return other || law ? undefined : book.laggings[name];
}
export const OTHERS =
  "Make the page anew with it, `wraparc page FILE`, or solve with `wraparc solve`";
/** Give every law of a pulley its numeric form, where the page does not find that itself: by the
 * book, or by what the server has solved. @param {any} drive as read @param {number} i
 * @param {any} doc @param {Book} book @param {Served} served
 * @returns {boolean} whether all have one */
function equipped(drive, i, doc, book, served) {
  const pulley = drive.pulleys[i];
  const laws = entryOf(doc, i, book)?.laws ?? {};
  const named = [doc.condition, doc.pulley[i].condition, ...casesOf(doc)].flat();
  for (const lagging of [pulley.lagging, ...pulley.conditions]) {
    if (lagging.law.compact) continue;
    const name = lagging.condition;
    const given = named.find((c) => c === name || c?.name === name);
    const key = given?.name ? JSON.stringify(given) : name;
    const found = laws[key] ?? Object.values(laws).find((l) => l.condition === name);
    if (found) equip(lagging.law, found.law, +found.steepest_fall);
  }
  for (const { load_case, prepared } of served) {
    const { condition } = drive.load_case(load_case);
    const { law } = pulley.lagging_in(condition);
    if (!law.compact) equip(law, prepared.law, +prepared.given.steepest_fall);
  }
  const cases = drive.cases ?? drive.load_cases;
  return cases.every((/** @type {any} */ c) => pulley.lagging_in(c.condition).law.compact);
}
/** @param {any} law @param {any} compact @param {number} fall */
const equip = (law, compact, fall) =>
  Object.assign(law, { compact: () => compact, steepest_fall: () => fall });
/** @param {any} doc @returns {any[]} */
const casesOf = (doc) => (doc.load_case ?? []).map((/** @type {any} */ c) => c.condition);
/** What is said of a law that the book does not have. @param {any} pulley @returns {Problem} */
const unknownLaw = ({ name, lagging }) =>
  left(
    `this page was made without this version of lagging ${lagging.name}. ${OTHERS}`,
    placeOf(name),
  );
/** @param {string} pulley */
const placeOf = (pulley) =>
  `pulley.${/^[\w-]+$/.test(pulley) ? pulley : JSON.stringify(pulley)}.lagging`;

/** The first pulley whose law the page does not have, as a problem.
 * @param {any} drive as read @param {any} doc @param {Book} book @param {Served} [served] */
export function lacking(drive, doc, book, served = []) {
  const missing = drive.pulleys.find(
    (/** @type {any} */ _, /** @type {number} */ i) => !equipped(drive, i, doc, book, served),
  );
  return missing && unknownLaw(missing);
}

/**
 * What a drive is judged by; or what is wrong with its document.
 * @param {Design} doc @param {Book} book @param {Served} [served] what the server has solved of a
 *   drive that differs by numbers alone
 * @returns {{judging: Assembled | null, problems: Problem[]}}
 */
export function assemble(doc, book, served = []) {
  const { found, problems } = readIn(doc, book);
  const refused = (/** @type {Problem[]} */ all) => ({ judging: null, problems: all });
  if (problems.length) return refused(problems);
  const not = found.cases ? "A train is not solved here." : beyond(found);
  if (not) return refused([left(not)]);
  const unknown = lacking(found, doc, book, served);
  if (unknown) return refused([unknown]);
  try {
    if (idleIn(found)) return refused([left(NO_PULL, "pulley")]);
    return { judging: assembled(found, arcsOf(found)), problems: [] };
  } catch (error) {
    if (!(error instanceof InputError)) throw error;
    return refused(/** @type {any} */ (error).problems.map(told));
  }
}
/** A drive with its arcs in numbers. @param {any} drive @param {any[]} arcs @returns {Assembled} */
export function assembled(drive, arcs) {
  const cases = arcs.map((arc) => {
    const pulley = drive.pulley(arc.pulley);
    const lagging = pulley.lagging_in(drive.load_case(arc.load_case).condition);
    const beside = arcs.filter((a) => a.load_case === arc.load_case);
    const { tested } = arc.law;
    return {
      load_case: arc.load_case,
      pulley: arc.pulley,
      lagging: lagging.name,
      condition: lagging.condition,
      belt: drive.belt.name,
      prepared: {
        law: lawIn(arc.law.compact()),
        given: numbersIn(givenOf(drive, arc)),
        inputs: [],
      },
      tested: tested && numbersOf({ ...tested }),
      criteria: numbersIn(criteriaOf(drive, beside, beside.indexOf(arc))),
    };
  });
  return { drive, arcs, cases, kinds: weakKinds(drive), meant: drive.load_case().name };
}
/** A drive in one of its load cases, the one that is meant if none is named.
 * @param {Assembled} of @param {string | null} [name] @returns {Assembled} */
export function inCase({ drive, meant }, name) {
  const one = alone(drive, name || meant);
  return assembled(one, arcsOf(one));
}
/** Plain numbers of an object. @param {any} of */
const numbersIn = (of) => numbersOf({ ...of });
/** A law in plain numbers. @param {any} law */
const lawIn = ({ kind, edges, coefficients, slips, onset_compliance }) => ({
  kind: +kind,
  edges: [...edges].map(Number),
  coefficients: [...coefficients].map(Number),
  slips: [...slips].map(Number),
  onset_compliance: +onset_compliance,
});
export const NO_PULL =
  "Te is zero: both tensions are equal; wraparc solve solves idle drives, this page does " + "not";
