// @ts-nocheck
// Made from the Python source by `make kernel`: change that, not this.
import { answer__operating_point, compression__block_modulus, compression__shape_factor, load_case__exit_behind, load_case__resultant, pitch__centrifugal_force, pull__idles, summary__available, summary__geometry_of, summary__held_creep, summary__overrun_loosens, summary__recovery_compliance, summary__spring_rate, summary__too_steep, tension_rules__behind_take_up, tension_rules__effective_keys, tension_rules__ends_of, tension_rules__families, tension_rules__fault_of, tension_rules__filled, tension_rules__less_runs, tension_rules__overridden, tension_rules__pull_given, tension_rules__speed_missing, tension_rules__too_few } from "./kernel.js";
import { cell__percent, cell__quantity } from "./cells.js";
import { cellOf } from "./base/digits.js";
import { belts, figureOf, isNumber, laggingNames, laggingText, overridden, parsed, readText, term } from "./documents.js";
import { $Decimal, $Dict, $Error, $KeyError, $Object, $OverflowError, $StopIteration, $Tuple, $TypeError, $ValueError, $add, $and, $at, $b, $bound, $call, $common, $eq, $fields, $format, $in, $iter, $k, $kept, $m, $made, $map, $math, $merged, $method, $mul, $named, $neg, $once, $or, $pow, $put, $re, $replaced, $repr, $shown, $sig, $slice, $str, $sub, $told, $truth } from "./python.js";
function drive_file__drive_from_document(document, file = "", folder = "", overrides = [], allow_paths = false) {
let belt, belt_record, cases, conditions, conveyor, criteria, laggings, message, own, parts, pulleys, record, records, report;

(document = overridden(document, overrides, file));
if (($in("train", document))) {
source__check_format(document, file);
(report = new Report(file));
(message = "makes it a train, not one drive");
report.add(["train"], message, "Use wraparc.load_train.");
report.raise_all();
}
([record, report] = source__read_tables($cca53, document, file));
(belt_record = $m.get(record, "belt"));
(belt = ($truth($b.isinstance(belt_record, Record)) ? drive_build__build_belt(belt_record, report) : null));
(own = $m.get(record, "lagging"));
(laggings = new Laggings(($truth($b.isinstance(own, "dict")) ? own : $map([])), folder, allow_paths, report));
(records = [...(function* () { for (const item of $iter($or($m.get(record, "pulley"), () => []))) { if (!($truth($b.isinstance(item, Record)))) continue; yield item; } })()]);
drive_file___name_pulley(records, report);
(conditions = conditions__build_conditions(record, report));
(pulleys = [...(function* () { for (const item of $iter(records)) { yield drive_build__build_pulley(item, laggings, conditions, report); } })()]);
across_keys__check_width(records, belt_record, report);
tensions__report_uncertain_twice(record, report);
(criteria = drive_build__build_criteria(record, belt, report));
(conveyor = null);
if (($in("conveyor", document))) {
([conveyor, cases] = conveyor_build__build_conveyor(record, belt, $bound(criteria, "take_up"), report));
} else {
(cases = drive_file___load_cases(record, records, belt, $bound(criteria, "take_up"), report));
}
drive_build__report_together(belt_record, belt, pulleys, drive__least_tensions(cases), report);
report.raise_all();
(parts = $map([...(function* () { for (const key of $iter(["title", "description", "creep_limit"])) { if (!(($in(key, record)))) continue; yield [key, $at(record, key)]; } })()]));
return report.sure((() => $call(Drive, [], [["belt", belt], ["pulleys", $b.tuple((function* () { for (const pulley of $iter(pulleys)) { yield pulley; } })())], ["load_cases", conditions__in_each_condition(cases, conditions)], ["criteria", criteria], ["conveyor", conveyor], ["read_from", new ReadFrom(document, folder, allow_paths)], ...parts])));
}
function source__check_format(document, file = "") {
let given, message, remedy, whole;

if ((!$in("format", document))) {
return null;
}
(given = $at(document, "format"));
(whole = $and($b.isinstance(given, "int"), () => !$truth($b.isinstance(given, "bool"))));
if (($truth(whole) && (1 <= given && given <= 1))) {
return null;
}
if (($truth(whole) && (given > 1))) {
(message = ("" + "must be at most " + $str(1) + " for this version of wraparc"));
(remedy = "Update wraparc.");
} else {
([message, remedy] = ["must be a whole number from 1", ("" + "Write format = " + $str(1) + ".")]);
}
throw errors__input_error(message, remedy, file, "format", $shown(given));
}
function errors__input_error(message, remedy = "", file = "", key = "", value = "", line = null) {

return new InputError(new Problem(message, remedy, file, key, value, line));
}
function source__read_tables(table, document, file) {
let report;

source__check_format(document, file);
(report = new Report(file));
return [table.read(document, [], report), report];
}
function drive_build__build_belt(record, report) {
let built, by_elongation, known, layers, mass, more, named, note, origins, own, published, remedy, sound, sources, uncertainty, unnamed, values;

(sources = origins__read_sources(record, (function* () { for (const e of $iter($c75bc)) { yield e.key; } })(), report));
(uncertainty = uncertain__read_uncertainty(record, $cc3f6, report));
(own = $or(origins__own_provenance(record, report), () => new Provenance()));
(more = $map([["name", "belt"], ["provenance", own]]));
(named = drive_build___named_belt(record, report));
(unnamed = $and((!$in("modulus", record)), () => !$truth(record.sound("name", "preset"))));
if (((named == null) && (($in("preset", record)) || $truth(unnamed)))) {
return null;
}
if ((named != null)) {
(more = $map([...(function* () { for (const key of $iter([...$iter($c2628), "provenance"])) { yield [key, $b.getattr(named, key)]; } })()]));
if (($in("modulus", record))) {
(more = $map([...(function* () { for (const [key, value] of $iter($m.items(more))) { if (!((!$in(key, $c5884)))) continue; yield [key, value]; } })()]));
}
(published = changes__belt_sources(named));
$put(more, "carcass_ends", ($truth($common($ced64, new Set([...$iter(record)]))) ? null : named.carcass_ends));
if ((($in("thickness", record)) || ($in("cord_diameter", record)))) {
([more, published] = [$map([...more, ["carcass", null]]), drive_build___without(published, "carcass")]);
}
(mass = drive_build___preset_mass(record, named));
if ((mass != null)) {
([more, published] = [$map([...more, ["mass", mass]]), $merged(published, $map([["mass", belt_mass__layer_source(named)]]))]);
}
(sources = $merged($merged(published, $map([...(function* () { for (const key of $iter($c2a894)) { if (!(($in(key, record)))) continue; yield [key, own]; } })()])), sources));
}
if (($in("elongation", record))) {
(by_elongation = drive_build___modulus_of_elongation(record, more, report));
if ((by_elongation == null)) {
return null;
}
(more = $merged(more, by_elongation));
(note = ("" + "by elongation, " + $str($at(record, "elongation"))));
(sources = $map([...sources, ["modulus", new Provenance(undefined, undefined, undefined, note)]]));
} else {
if ((!$truth($common(new Set(["modulus"]), new Set([...$iter(more), ...$iter(record)]))) && $truth(record.sound("modulus", "elongation")))) {
(remedy = "Write modulus = \"12960 kN/m\" or preset = \"EP 630/3\".");
report.add([...$iter(record.place), "modulus"], "missing", remedy);
return null;
}
}
(more = $map([...(function* () { for (const [key, v] of $iter($m.items(more))) { if (!((($eq(key, "provenance")) || (!$in(key, record))))) continue; yield [key, v]; } })()]));
(origins = $map([["sources", sources], ["uncertainty", uncertainty]]));
(built = $method($c808d, "built", [record, report], [...origins, ...more]));
(known = $or(($in("modulus", more)), () => ($in("modulus", record))));
if (((built != null) || !($truth(known) && $truth(record.sound("width", "modulus"))))) {
return built;
}
(values = $map([...(function* () { for (const [key, value] of $iter($m.items(record))) { if (!((!$in(key, record.faulty)))) continue; yield [key, value]; } })()]));
(sound = new Record(values, $bound(record, "place"), $bound(record, "raw")));
(layers = ((!$truth(record.sound()) && $truth(record.sound(...$iter($c2d22), "thickness"))) ? report : new Report()));
(built = $method($c808d, "built", [sound, layers], [["sources", $map([])], ...more]));
$m.pop(sound, "thickness", null);
return $or(built, () => $method($c808d, "built", [sound, new Report()], [["sources", $map([])], ...more]));
}
function origins__read_sources(record, keys, report) {
let key, place, provenance, remedy, sources, table;

(keys = [...(function* () { for (const key of $iter(keys)) { if (!((!$in(key, ["sources", "provenance", "name", "preset"])))) continue; yield key; } })()]);
(sources = $map([]));
for ([key, table] of $iter($m.items($m.get(record, "sources", $map([]))))) {
if ((!$in(key, keys))) {
(place = [...$iter(record.place), "sources", key]);
(remedy = ($truth(report.full) ? "" : tables__unknown_key_remedy(key, keys)));
report.add(place, "is no key of this table", remedy);
} else {
if ($truth($b.isinstance(table, Record))) {
(provenance = origins__read_provenance(table, report));
if ((provenance != null)) {
$put(sources, key, provenance);
}
}
}
}
return sources;
}
function origins__read_provenance(record, report) {
let kind, made;

(kind = (($in("kind", record)) ? $map([["kind", $b.str($at(record, "kind"))]]) : $map([])));
(made = $method($cc542, "built", [record, report], [...kind]));
return made;
}
function tables__unknown_key_remedy(key, known) {

return $or(errors__nearest(key, known), () => ("" + "Write one of " + $str(errors__format_list([...$iter(known)])) + "."));
}
function errors__nearest(given, known, most = 3) {

return errors__did_you_mean([...(function* () { for (const word of $iter(errors__near(given, known, most))) { yield $shown(word); } })()]);
}
function errors__near(given, known, most = 3) {
let alike, by_likeness, within, words;

if (!$truth($b.isinstance(given, "str"))) {
return [];
}
(words = $b.list(known));
(within = [...(function* () { for (const word of $iter(words)) { if (!((($b.len(given) > 2) && ($in(given, word))))) continue; yield word; } })()]);
(alike = [...(function* () { for (const word of $iter(words)) { yield [errors___likeness(word, $slice(given, null, 100)), word]; } })()]);
(by_likeness = $b.sorted([...(function* () { for (const pair of $iter(alike)) { if (!(($at(pair, 0) >= 0.55))) continue; yield pair; } })()], $k({reverse: true})));
return $slice($b.list($b.fromkeys($add(within, [...(function* () { for (const [_, word] of $iter($slice(by_likeness, null, most))) { yield word; } })()]))), null, most);
}
function errors___likeness(word, given) {
let size;

(size = $add($b.len(word), $b.len(given)));
return ($truth(size) ? ($mul(2.0, errors___alike(word, given)) / size) : 1.0);
}
function errors___alike(one, other) {
let at, before, first, found, i, j, letter, run, runs, size, there;

([size, at, there] = [0, 0, 0]);
(runs = $mul([0], $add($b.len(other), 1)));
for ([i, letter] of $iter($b.enumerate(one))) {
(before = 0);
for ([j, found] of $iter($b.enumerate(other))) {
(run = (($eq(letter, found)) ? $add(before, 1) : 0));
(before = $at(runs, $add(j, 1)));
$put(runs, $add(j, 1), run);
if ((run > size)) {
([size, at, there] = [run, $sub($add(i, 1), run), $sub($add(j, 1), run)]);
}
}
}
if (($eq(size, 0))) {
return 0;
}
(first = errors___alike($slice(one, null, at), $slice(other, null, there)));
return $add($add(first, size), errors___alike($slice(one, $add(at, size), null), $slice(other, $add(there, size), null)));
}
function errors__did_you_mean(texts) {

return ($truth(texts) ? ("" + "Did you mean " + $str($m.join(" or ", texts)) + "?") : "");
}
function errors__format_list(texts, most = 6) {
let more;

(more = $sub($b.len(texts), most));
if ((more <= 1)) {
return $m.join(", ", texts);
}
return ("" + $str($m.join(", ", $slice(texts, null, most))) + " and " + $str(more) + " more");
}
function uncertain__read_uncertainty(record, names, report) {
let found, given, key, message, name, place, value;

(found = $map([]));
(given = $map([]));
for ([key, value] of $iter($m.items($m.get(record, "uncertainty", $map([]))))) {
([name, place] = [$m.get($c205c, key, key), [...$iter(record.place), "uncertainty", key]]);
if ((!$in(name, names))) {
report.add(place, "has no uncertainty", uncertain___remedy(key, names));
} else {
if (($in(name, given))) {
(message = ("" + "contradicts that of " + $str($at(given, name))));
report.add(place, message, "Remove one of them.", $at($at(record.raw, "uncertainty"), key));
} else {
if ((value !== $ca9ba)) {
$put(found, name, value);
}
}
}
$m.setdefault(given, name, key);
}
return found;
}
function uncertain___remedy(key, names) {
return (($b.len(names) > 1) ? tables__unknown_key_remedy(key, names) : ("" + "Write " + $str($at(names, 0)) + "."));
}
function origins__own_provenance(record, report) {
let table;

(table = $m.get(record, "provenance"));
return ($truth($b.isinstance(table, Record)) ? origins__read_provenance(table, report) : null);
}
function drive_build___named_belt(record, report) {
let before, found, name, place, problem, stated;

(stated = $or(($in("modulus", record)), () => ($in("elongation", record))));
if (($in("preset", record))) {
([place, name] = [[...$iter(record.place), "preset"], $at(record, "preset")]);
return report.tried((() => loader__belt(name, !$truth(stated))), place, name);
}
if ((($in("modulus", record)) || (!$in("name", record)) || !$truth(record.sound("modulus", "elongation")))) {
return null;
}
([place, name] = [[...$iter(record.place), "name"], $at(record, "name")]);
(before = $b.len($bound(report, "problems")));
(found = report.tried((() => standard_belts__standard_belt(name)), place, name));
(problem = (((found == null) || $truth(stated)) ? null : standard_belts__modulus_problem(found)));
if ((problem != null)) {
report.add(place, $bound(problem, "message"), $bound(problem, "remedy"), name);
}
if (($b.len($bound(report, "problems")) > before)) {
record.faulty.add("name");
return null;
}
return found;
}
function loader__belt(name, with_modulus = true) {
let found, problem;

(found = loader__find_belt(name));
if ((found == null)) {
throw loader__unknown_name("belt", name, (function* () { for (const b of $iter(belts())) { yield b.name; } })(), "wraparc belts");
}
(problem = ($truth(with_modulus) ? standard_belts__modulus_problem(found) : null));
if ((problem != null)) {
throw new InputError(problem);
}
return found;
}
function loader__find_belt(name) {
let found, wanted;

(wanted = $once(loader___plain, $kept_loader___plain)(name));
(found = $b.next((function* () { for (const b of $iter(belts())) { if (!(($eq($once(loader___plain, $kept_loader___plain)($bound(b, "name")), wanted)))) continue; yield b; } })(), null));
return $or(found, () => standard_belts__standard_belt(name));
}
function loader___plain(name) {
return $m.join("", $m.split($m.casefold(name)));
}
const $kept_loader___plain = new Map();
function standard_belts__standard_belt(name) {
let ends, found, kind, modulus, note, of, over, rating, sources, strength;

(of = belt_names__parse_belt_name(name));
if ((of == null)) {
return null;
}
(kind = ($truth(of.is_steel) ? "steel cord" : "fabric"));
([strength, rating, sources] = standard_belts___tensions(of, kind));
([modulus, ends] = [NaN, null]);
if (($in(of.carcass, $c88e4))) {
(over = $at($c88e4, of.carcass));
([modulus, ends] = [$mul(strength, over.value), [$mul(strength, over.least), $mul(strength, over.most)]]);
(note = ("" + $format(over.value, ("" + "g")) + " times the strength, published " + $format(over.least, ("" + "g")) + " to " + $format(over.most, ("" + "g"))));
$put(sources, "modulus", standard_belts___estimated($at($c849a, of.carcass), note));
}
(found = new CatalogueBelt($m.join(" ", $m.split(name)), kind, rating, modulus, ends, strength, undefined, standard_belts___known($bound(of, "pulley_cover")), standard_belts___known($bound(of, "carry_cover")), undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, new Provenance(undefined, undefined, undefined, ("" + "by its name: " + $str(of.standard))), sources));
(found = ($truth(of.is_steel) ? standard_belts___with_cords(found, strength) : standard_belts___with_plies(found, of, strength)));
return standard_belts___with_pulley(found, $bound(of, "carcass"));
}
function belt_names__parse_belt_name(name) {
let found, pattern, text;

(text = $m.join(" ", $m.split($m.upper($m.translate(name, $c01ee)))));
(found = $m.fullmatch($c25ce, text));
if ((found != null)) {
return belt_names___textile(found, name);
}
(found = $m.fullmatch($c1fa2, text));
if ((found != null)) {
return belt_names___cords(found, name);
}
for (pattern of $iter($caeec)) {
(found = $m.fullmatch(pattern, text));
if ((found != null)) {
return belt_names___rated(found, name);
}
}
if (($truth($m.fullmatch($c77e8, text)) && $truth(belt_names__near_names(text)))) {
throw belt_names___asked(name, "is no standard name of a belt", text);
}
return null;
}
function belt_names___textile(found, name) {
let by_ply, carcass, plies, strength, wrong;

([strength, plies] = [$b.float($at(found, "strength")), $b.int($at(found, "plies"))]);
if ($truth($at(found, "piw"))) {
return belt_names___rated(found, name);
}
([carcass, by_ply] = [$at(found, "carcass"), []]);
if ((($in(strength, $c84f8)) && (1 <= plies && plies <= 8))) {
(by_ply = [("" + $str(carcass) + " " + $format($mul(strength, plies), ("" + "g")) + "/" + $str(plies))]);
}
if (!$truth(belt_names___is_woven(strength, plies))) {
(wrong = ("" + "no belt has " + $format(strength, ("" + "g")) + " N/mm in " + $str(plies) + " " + $str((($eq(plies, 1)) ? "ply" : "plies"))));
throw belt_names___asked(name, wrong, ("" + $str(carcass) + " " + $format(strength, ("" + "g")) + "/" + $str(plies)), by_ply);
}
if ((($eq($at(found, "sign"), "X")) && $truth(by_ply))) {
(wrong = ("" + $format(strength, ("" + "g")) + " N/mm may be that of a ply or of all"));
throw belt_names___asked(name, wrong, "", [...$iter(by_ply), ("" + $str(carcass) + " " + $format(strength, ("" + "g")) + "/" + $str(plies))]);
}
return new BeltName($at(found, "carcass"), $mul(1000.0, strength), NaN, plies, ...$iter(belt_names___covers(found, name)));
}
function belt_names___rated(found, name) {
let plies, rating, tension;
([rating, plies] = [$b.float($at(found, "strength")), $b.int($or($at(found, "plies"), () => 0))]);
if ((plies > 8)) {
throw belt_names___asked(name, ("" + "no belt has " + $str(plies) + " plies"), ("" + $format(rating, ("" + "g")) + " PIW"));
}
(tension = $mul(rating, parse__unit_factor("PIW", "force_per_width")));
return new BeltName("PIW", NaN, tension, plies, ...$iter(belt_names___covers(found, name)));
}
function belt_names___asked(name, message, text, first = null) {
let meant, names, remedy;
(names = [...$iter($or(first, () => [])), ...$iter(($truth(text) ? belt_names__near_names(text) : []))]);
(meant = [...(function* () { for (const known of $iter($b.fromkeys($slice(names, null, 3)))) { yield $shown(known); } })()]);
(remedy = $or(errors__did_you_mean(meant), () => "Write for example \"EP 630/3\"."));
return new InputError(new Problem(message, remedy, undefined, undefined, $shown(name)));
}
function belt_names__near_names(text) {
let names, plain;

(plain = belt_names___plain(text));
(names = $map([...(function* () { for (const known of $iter(belt_names___standard_names())) { yield [belt_names___plain(known), known]; } })()]));
return [...(function* () { for (const key of $iter(errors__near(plain, names))) { yield $at(names, key); } })()];
}
function belt_names___plain(text) {
return $m.sub($cb164, "", $m.translate($m.upper(text), $cade6));
}
function belt_names___standard_names() {
let textile;

(textile = [...(function* () { for (const carcass of $iter(["EP", "PN", "EE", "NN"])) { for (const strength of $iter($c3cf7)) { for (const plies of $iter($b.range(2, 7))) { if (!(($at($c84f8, 0) <= (strength / plies) && (strength / plies) <= $at($c84f8, $neg(1))))) continue; yield ("" + $str(carcass) + " " + $str(strength) + "/" + $str(plies)); }}} })()]);
return $add(textile, [...(function* () { for (const strength of $iter($c65c8)) { yield ("" + "ST " + $str(strength)); } })()]);
}
function parse__unit_factor(unit, dimension) {
let resolved;

(resolved = parse___checked_unit(unit, dimension, unit));
if ($truth(resolved.zero)) {
throw parse___refused(unit, "has its zero elsewhere than 0 K", "Convert the column to K.");
}
return $b.float($bound(resolved, "factor"));
}
function parse___checked_unit(text, dimension, given, example = "") {
let error, found, kind, measured, message, remedy, unit;
(kind = $at($c22c8, dimension));
try {
(unit = $once(parse___resolve, $kept_parse___resolve)(text, ($in(dimension, $c33fe))));
} catch ($error) {
if ($error instanceof _UnitTextError) {
error = $error;
(remedy = $or(error.remedy, () => parse___meant(text, error, dimension, example)));
throw parse___refused(given, $b.str(error), remedy);
} else throw $error;
}
if ((!$eq(unit.powers, $once(parse___powers, $kept_parse___powers)(dimension)))) {
(measured = parse__dimension_of(text));
(found = ($truth(measured) ? $at($c22c8, measured).name : "of no dimension used here"));
(message = ("" + $str(found) + ", where " + $str(kind.name) + " is needed"));
(remedy = $or(parse___by_gravity(text, dimension), () => parse___for_example(dimension, example)));
throw parse___refused(given, message, remedy);
}
return unit;
}
function parse___meant(text, error, dimension, example) {
let fits, forces, texts, tons, units;

if (($in(error.name, $c1360))) {
(tons = [["t", "1000 kg"], ["ston", "2000 lb"], ["lton", "2240 lb"]]);
(forces = [["tf", "1000 kgf"], ["kip", "1000 lbf"]]);
for (units of $iter([tons, forces])) {
if ($truth(parse___fits($m.replace(text, $bound(error, "name"), $at($at(units, 0), 0)), dimension))) {
(texts = [...(function* () { for (const [unit, size] of $iter(units)) { yield ("" + $str($m.replace(text, $bound(error, "name"), unit)) + " (" + $str(size) + ")"); } })()]);
return ("" + "Write " + $str($m.join(", ", $slice(texts, null, $neg(1)))) + " or " + $str($at(texts, $neg(1))) + ".");
}
}
}
(fits = [...(function* () { for (const name of $iter(error.meant)) { if (!($truth(parse___fits($m.replace(text, $bound(error, "name"), name), dimension)))) continue; yield name; } })()]);
(fits = $or(fits, () => parse___corrected(text, dimension, 3)));
if ($truth(fits)) {
return errors__did_you_mean($slice(fits, null, 2));
}
return parse___for_example(dimension, example);
}
function parse___fits(text, dimension) {

try {
return ($eq($once(parse___resolve, $kept_parse___resolve)(text, ($in(dimension, $c33fe))).powers, $once(parse___powers, $kept_parse___powers)(dimension)));
} catch ($error) {
if ($error instanceof _UnitTextError) {
return false;
} else throw $error;
}
}
function parse___resolve(text, of_mass = false) {
return parse___evaluate(text, ($truth(of_mass) ? $once(parse___units_of_mass, $kept_parse___units_of_mass)() : $once(parse___units, $kept_parse___units)()));
}
const $kept_parse___resolve = new Map();
function parse___units_of_mass() {
let known;

(known = $once(parse___units, $kept_parse___units)());
return $merged(known, $b.fromkeys(["lb", "lbs"], $at(known, "lbm")));
}
const $kept_parse___units_of_mass = new Map();
function parse___units() {
let definition, known, of, size, unit;

(size = $b.len($c388d));
(known = $map([...(function* () { for (const [i, name] of $iter($b.enumerate($c388d))) { yield [name, new Unit($b.Decimal(1), $b.tuple((function* () { for (const j of $iter($b.range(size))) { yield $b.int(($eq(i, j))); } })()))]; } })()]));
for (definition of $iter($c50ba)) {
(of = parse___evaluate($bound(definition, "unit"), known));
(unit = new Unit($mul(definition.factor, of.factor), $bound(of, "powers"), $bound(definition, "zero")));
$m.update(known, $b.fromkeys(definition.names, unit));
}
return known;
}
const $kept_parse___units = new Map();
function parse___evaluate(text, known) {
let factors, match, message, name, over, plain, power, powers, product, under, unit;
(plain = $m.replace($m.strip($m.translate(text, $cdac1)), "**", "^"));
if (($in(plain, known))) {
return $at(known, plain);
}
(match = (($b.len(plain) <= 40) ? $m.fullmatch($c0fad, plain) : null));
if ((match == null)) {
throw new _UnitTextError(("" + "the unit " + $str($shown(text)) + " cannot be read"));
}
([over, under] = [$or($at(match, "over"), () => ""), $or($at(match, "one"), () => $or($at(match, "under"), () => ""))]);
(factors = [...(function* () { for (const [name, power] of $iter($m.findall($c09cc, over))) { yield [name, $b.int($or(power, () => 1))]; } })()]);
(factors = $add(factors, [...(function* () { for (const [name, power] of $iter($m.findall($c09cc, under))) { yield [name, $neg($b.int($or(power, () => 1)))]; } })()]));
if ((($eq($b.len(factors), 1)) && ($eq($at($at(factors, 0), 1), 1)))) {
return parse___named($at($at(factors, 0), 0), known);
}
(product = new Unit($b.Decimal(1), $mul([0], $b.len($c388d))));
for ([name, power] of $iter(factors)) {
(unit = parse___named(name, known));
if ($truth(unit.zero)) {
(message = ("" + $str(name) + " cannot be part of a compound unit: its zero is not 0 K"));
throw new _UnitTextError(message, "Use K.");
}
(powers = $b.tuple((function* () { for (const [a, b] of $iter($b.zip($bound(product, "powers"), $bound(unit, "powers"), $k({strict: true})))) { yield $add(a, $mul(power, b)); } })()));
(product = new Unit($mul(product.factor, $pow(unit.factor, power)), powers));
}
return product;
}
function parse___named(name, known) {
let meant, same_but_case, unit;
(unit = $m.get(known, name));
if ((unit != null)) {
return unit;
}
if (($in(name, $c1360))) {
throw new _UnitTextError(("" + $str(name) + " may be metric, short or long"), "", name);
}
(same_but_case = [...(function* () { for (const other of $iter(known)) { if (!(($eq($m.casefold(other), $m.casefold(name))))) continue; yield other; } })()]);
(meant = $b.tuple($or(same_but_case, () => errors__near(name, known, 8))));
throw new _UnitTextError(("" + "unknown unit " + $str($shown(name))), "", name, meant);
}
function parse___powers(dimension) {
return $once(parse___resolve, $kept_parse___resolve)($bound($at($c22c8, dimension), "si_unit")).powers;
}
const $kept_parse___powers = new Map();
function parse___corrected(text, dimension, most) {
let error, found, name;

try {
$once(parse___resolve, $kept_parse___resolve)(text, ($in(dimension, $c33fe)));
} catch ($error) {
if ($error instanceof _UnitTextError) {
error = $error;
for (name of $iter(($truth(most) ? error.meant : []))) {
(found = parse___corrected($m.replace(text, $bound(error, "name"), name), dimension, $sub(most, 1)));
if ($truth(found)) {
return found;
}
}
return [];
} else throw $error;
}
return ($truth(parse___fits(text, dimension)) ? [$m.strip(text)] : []);
}
function parse___for_example(dimension, example) {
return ("" + "Write for example " + $str($shown($or(example, () => $at($c22c8, dimension).example))) + ".");
}
function parse___refused(given, message, remedy) {
return errors__input_error(message, remedy, undefined, undefined, $shown(given));
}
function parse__dimension_of(unit) {
let powers;

try {
(powers = $once(parse___resolve, $kept_parse___resolve)(unit).powers);
} catch ($error) {
if ($error instanceof _UnitTextError) {
return null;
} else throw $error;
}
if ((($in("J", unit)) && ($eq(powers, $once(parse___powers, $kept_parse___powers)("energy_per_area"))))) {
return "energy_per_area";
}
return $b.next((function* () { for (const name of $iter($c5fbb)) { if (!(($eq($once(parse___powers, $kept_parse___powers)(name), powers)))) continue; yield name; } })(), null);
}
function parse___by_gravity(text, dimension) {
let meant, other, pattern, replaced;

for ([pattern, other, meant] of $iter($ca649)) {
(replaced = $m.sub(pattern, other, text));
if (((!$eq(replaced, text)) && $truth(parse___fits(replaced, dimension)))) {
return ("" + "Write " + $str($m.strip(replaced)) + " if it is " + $str(meant) + ".");
}
}
return "";
}
function belt_names___covers(found, name) {
let carry, covers, inch, message, parts, pulley;

(covers = [NaN, NaN]);
if (($at(found, "carry") != null)) {
([carry, pulley] = (function* () { for (const key of $iter(["carry", "pulley"])) { yield ("" + $str($m.replace($at(found, key), ",", ".")) + " mm"); } })());
(covers = [parse__parse_quantity(carry, "length"), parse__parse_quantity(pulley, "length")]);
} else {
if (($at(found, "top") != null)) {
(inch = parse__unit_factor("in", "length"));
(parts = [...(function* () { for (const key of $iter(["top", "bottom"])) { yield $m.split($at(found, key), "/"); } })()]);
(covers = [($mul(inch, $b.float($at($at(parts, 0), 0))) / $b.float($at($at(parts, 0), 1))), ($mul(inch, $b.float($at($at(parts, 1), 0))) / $b.float($at($at(parts, 1), 1)))]);
}
}
if ((($at(covers, 0) > 0.035) || ($at(covers, 1) > 0.035))) {
(message = ("" + "no cover is thicker than " + $format($mul(1000.0, 0.035), ("" + "g")) + " mm"));
throw new InputError(new Problem(message, "Write covers as \"6+3\", in mm.", undefined, undefined, $shown(name)));
}
return [$at(covers, 0), $at(covers, 1), $m.strip($or($at(found, "grade"), () => ""), " -,")];
}
function parse__parse_quantity(value, dimension, example = "") {
let kind, problem;

(kind = $at($c22c8, dimension));
if (($truth($b.isinstance(value, "int", "float")) && !$truth($b.isinstance(value, "bool")))) {
if (($eq(dimension, "number"))) {
return numbers__finite(value, value);
}
throw parse___no_unit(value, dimension, example);
}
if (!$truth($b.isinstance(value, "str"))) {
(problem = ("" + "neither text nor a number, where " + $str(kind.name) + " is needed"));
throw parse___refused(value, problem, parse___for_example(dimension, example));
}
return $once(parse___read, $kept_parse___read)(value, dimension, example);
}
function numbers__finite(number, given) {
let value;

try {
(value = $b.float(number));
} catch ($error) {
if ($error instanceof $OverflowError) {
(value = Infinity);
} else throw $error;
}
if (!$truth($math.isfinite(value))) {
throw numbers___refused(given, "not a finite number", "Give the size that was measured or meant.");
}
if ((($eq(value, 0)) && (!$eq(number, 0)))) {
throw numbers___refused(given, "too small to tell from zero", "Write 0, or check the exponent.");
}
return value;
}
function numbers___refused(given, message, remedy) {
return errors__input_error(message, remedy, undefined, undefined, $shown(given));
}
function parse___no_unit(value, dimension, example) {
let kind, message;
(kind = $at($c22c8, dimension));
(message = ("" + "no unit, where " + $str(kind.name) + " is needed"));
return parse___refused(value, message, ("" + "Write the unit too, for example " + $str($shown($or(example, () => kind.example))) + "."));
}
function parse___read(text, dimension, example) {
let number, unit, unit_text;
([number, unit_text] = numbers__split_number(text));
if ((!$truth(unit_text) && (!$eq(dimension, "number")))) {
throw parse___no_unit(text, dimension, example);
}
(unit = parse___checked_unit(unit_text, dimension, text, example));
return numbers__finite($mul($sub(number, unit.zero), unit.factor), text);
}
const $kept_parse___read = new Map();
function numbers__split_number(text) {
let inverse_unit, match, rest, stripped;

if (($b.len(text) > 80)) {
throw numbers___refused(text, ("" + "longer than " + $str(80) + " characters"), "Shorten it.");
}
(stripped = $m.strip(text));
(match = $m.match($c7c8f, stripped));
if ((match == null)) {
throw numbers___malformed(text, stripped);
}
(rest = $m.strip($slice(stripped, $m.end(match), null)));
(inverse_unit = $and(($m.end(match) < $b.len(stripped)), () => $m.match($cf432, rest)));
if (($truth(rest) && ($truth($m.match($c9926, rest)) || $truth($m.isdecimal($at(rest, 0)))) && !$truth(inverse_unit))) {
throw numbers___malformed(text, stripped);
}
return [numbers___decimal($m.group(match), text), rest];
}
function numbers___malformed(text, stripped) {
let digits, head, message, rest;

(head = $m.match($cf327, stripped));
(digits = ($truth(head) ? $m.strip($m.group(head)) : ""));
(rest = ($truth(head) ? $m.strip($slice(stripped, $b.len($m.group(head)), null)) : ""));
if (!$truth(stripped)) {
return numbers___refused(text, "empty, where a number is needed", "Write a number.");
}
if ($truth($m.match($ccb7f, stripped))) {
return numbers___refused(text, "not a finite number", "Give the size that was measured or meant.");
}
if ($truth($b.any((function* () { for (const c of $iter(stripped)) { yield $and($m.isdecimal(c), () => !$truth($m.isascii(c))); } })()))) {
return numbers___refused(text, "digits other than 0-9", "Write digits and a decimal point: 1234.5.");
}
if (($in(",", digits))) {
(message = "a comma can mean decimal point or thousands separator");
return numbers___refused(text, message, numbers___write(numbers___comma_readings(digits), rest));
}
if (($truth($m.search($ced43, digits)) && (!$in("/", digits)))) {
(message = "digits in groups can be one number or several");
return numbers___refused(text, message, numbers___write([$m.sub($ced43, "", digits)], rest));
}
if (($in("/", digits))) {
return numbers___refused(text, "a fraction, where a decimal number is needed", "Write digits and a decimal point: 1234.5.");
}
if (($in("−", digits))) {
return numbers___refused(text, "a typographic minus sign", "Use the plain hyphen-minus '-'.");
}
return numbers___refused(text, "not a plain number", "Write digits and a decimal point: 1234.5.");
}
function numbers___comma_readings(digits) {
let _, bare_whole, decimal, decimals, exponent, joined, power, readings, whole;

(exponent = $m.search($c0f01, digits));
(power = ($truth(exponent) ? $m.group(exponent) : ""));
(joined = $m.sub($ced43, "", $m.removesuffix(digits, power)));
([whole, _, decimals] = $m.rpartition(joined, ","));
(bare_whole = $m.sub($cb5cc, "", whole));
(readings = [$m.replace(joined, ",", "")]);
if (((!$in(",", whole)) && (!$in(".", decimals)))) {
(decimal = ("" + $str(bare_whole) + "." + $str(decimals)));
(readings = ((($in(".", whole)) || (!$eq($b.len(decimals), 3))) ? [decimal] : [...$iter(readings), decimal]));
}
return [...(function* () { for (const reading of $iter(readings)) { yield $add(reading, power); } })()];
}
function numbers___write(readings, rest) {
if (!$truth($b.all((function* () { for (const reading of $iter(readings)) { yield $m.fullmatch($c7c8f, reading); } })()))) {
return "Write digits and a decimal point: 1234.5.";
}
return $add($add("Write ", $m.join(" or ", (function* () { for (const r of $iter(readings)) { yield $shown($m.strip(("" + $str(r) + " " + $str(rest)))); } })())), ".");
}
function numbers___decimal(digits, given) {
let exponent;
(exponent = $m.search($c0f01, digits));
if (((exponent != null) && ($b.len($m.lstrip($m.group(exponent, 1), "0")) > 4))) {
throw numbers___refused(given, "its exponent is out of range", "Check the exponent.");
}
return $b.Decimal(digits);
}
function belt_names___is_woven(strength, plies) {
let known;

(known = $or(($in(strength, $c3cf7)), () => $b.any((function* () { for (const ply of $iter($c84f8)) { yield ($eq(strength, $mul(plies, ply))); } })())));
return $and(known, () => $and((1 <= plies && plies <= 8), () => ($at($c3d44, 0) <= (strength / plies) && (strength / plies) <= $at($c3d44, 1))));
}
function belt_names___cords(found, name) {
let strength;
(strength = $b.float($at(found, "strength")));
if ((!$in(strength, $c65c8))) {
throw belt_names___asked(name, ("" + "no type ST " + $format(strength, ("" + "g")) + " is listed"), ("" + "ST " + $format(strength, ("" + "g"))));
}
return new BeltName("ST", $mul(1000.0, strength), NaN, 0, ...$iter(belt_names___covers(found, name)));
}
function standard_belts___tensions(of, kind) {
let note, rating, safety, source;

if (($eq(of.carcass, "PIW"))) {
(source = "CWP and Skecon, conveyor belt strength");
(note = ("" + $format(10.0, ("" + "g")) + " times the rated tension, makers have 8 to 10"));
return [$mul(10.0, of.rating), of.rating, $map([["strength", standard_belts___estimated(source, note)]])];
}
(safety = $at($c60ad, kind));
(note = ("" + "strength over " + $format(safety.value, ("" + ".3g")) + ", makers have " + $format(safety.least, ("" + ".3g")) + " to " + $format(safety.most, ("" + ".3g"))));
(rating = $map([["rating", standard_belts___estimated($at($c22da, kind), note)]]));
return [of.strength, (of.strength / safety.value), rating];
}
function standard_belts___estimated(source, note) {
return new Provenance("published", source, undefined, ("" + "estimated: " + $str(note)));
}
function standard_belts___known(value) {
return (($eq(value, value)) ? value : null);
}
function standard_belts___with_cords(belt, strength) {
let cords, sources;

(cords = $m.get($c9cad, $b.round($mul(0.001, strength))));
if ((cords == null)) {
return belt;
}
(sources = $map([...belt.sources, ["carcass", standard_belts___estimated($bound(cords, "source"), ("" + "cord diameter, makers differ by " + $format($mul(100.0, 0.08), ("" + "g")) + " %"))], ["carcass_mass", standard_belts___estimated($at($cb302, "steel cord"), "by strength and cords, to 7 %")], ["cover_mass", standard_belts___estimated($at($cb302, "steel cord"), "covers of the same catalogue")]]));
if ((standard_belts___known($bound(cords, "pitch")) != null)) {
$put(sources, "cord_pitch", standard_belts___estimated($bound(cords, "source"), "cord pitch, makers differ"));
}
return $replaced(belt, new Map([["carcass", cords.diameter], ["carcass_ends", [$mul($sub(1.0, 0.08), cords.diameter), $mul($add(1.0, 0.08), cords.diameter)]], ["cord_pitch", standard_belts___known($bound(cords, "pitch"))], ["carcass_mass", $add($mul(3.2e-06, strength), $mul(1250.0, cords.diameter))], ["cover_mass", 1150.0], ["sources", sources]]));
}
function standard_belts___with_plies(belt, of, strength) {
let key, mass, note, ply, share, spread, thickness;

if (($eq(of.plies, 0))) {
return belt;
}
([share, spread, key] = [1.0, $ca34d, "EP"]);
if (($eq(of.carcass, "NN"))) {
([share, spread, key] = [0.85, $cf010, "NN"]);
} else {
if (($in(of.carcass, $cc26f))) {
(spread = [$mul($at($cf010, 0), 0.85), $at($ca34d, 1)]);
}
}
(ply = $mul(share, $add(0.0007, ($mul(3e-09, strength) / of.plies))));
(thickness = ($b.round($mul($mul(10000.0, of.plies), ply)) / 10000.0));
(note = ("" + "by plies and their strength, published " + $format($at(spread, 0), ("" + ".2g")) + " to " + $format($at(spread, 1), ("" + ".3g")) + " of it"));
(mass = ("" + $format($mul(0.001, 1100.0), ("" + "g")) + " kg/m2 a mm of carcass, published 0.9 to 1.25"));
return $replaced(belt, new Map([["carcass", thickness], ["carcass_ends", [$mul($at(spread, 0), thickness), $mul($at(spread, 1), thickness)]], ["carcass_mass", $mul(1100.0, thickness)], ["cover_mass", 1200.0], ["sources", $map([...belt.sources, ["carcass", standard_belts___estimated($at($c4e18, key), note)], ["carcass_mass", standard_belts___estimated($at($cb302, "fabric"), mass)], ["cover_mass", standard_belts___estimated($at($cb302, "fabric"), "covers of the same catalogue")]])]]));
}
function standard_belts___with_pulley(belt, carcass) {
let least, note, sizes, source;

if (((belt.carcass == null) || (!$in(carcass, $c197d)))) {
return belt;
}
(least = $mul($at($c197d, carcass), belt.carcass));
(sizes = [...(function* () { for (const size of $iter($c4076)) { if (!((size >= $sub(least, 1e-09)))) continue; yield size; } })()]);
if (!$truth(sizes)) {
return belt;
}
(note = ("" + $format($at($c197d, carcass), ("" + "g")) + " times the thickness of the tension member, rounded up"));
(source = $map([["least_pulley_diameter", standard_belts___estimated("DIN 22101, group A", note)]]));
return $replaced(belt, new Map([["least_pulley_diameter", $at(sizes, 0)], ["sources", $map([...belt.sources, ...source])]]));
}
function loader__unknown_name(what, name, known, command) {
let by_plain, remedy, texts;

(by_plain = $map([...(function* () { for (const k of $iter(known)) { yield [$once(loader___plain, $kept_loader___plain)(k), k]; } })()]));
(texts = [...(function* () { for (const key of $iter(errors__near($once(loader___plain, $kept_loader___plain)(name), by_plain))) { yield $shown($at(by_plain, key)); } })()]);
(remedy = $or(errors__did_you_mean(texts), () => ("" + "List them: " + $str(command) + ".")));
return errors__input_error(("" + "the catalogue has no " + $str(what) + " of this name"), remedy, undefined, undefined, $shown(name));
}
function standard_belts__modulus_problem(belt) {
let of, options, size;

if (($eq(belt.modulus, belt.modulus))) {
return null;
}
(of = belt_names__parse_belt_name($bound(belt, "name")));
if ((of == null)) {
return null;
}
(size = ("" + $format($mul(0.001, of.strength), ("" + "g")) + "/" + $str(of.plies)));
(options = [...(function* () { for (const carcass of $iter($m.get($cc26f, $bound(of, "carcass"), []))) { yield $shown(("" + $str(carcass) + " " + $str(size))); } })()]);
return new Problem(("" + "warp of " + $str(of.carcass) + " is polyester or polyamide"), ("" + "Write " + $str($m.join(" or ", options)) + ", or give modulus or elongation."), undefined, undefined, $shown($bound(belt, "name")));
}
function changes__belt_sources(row) {

return $map([...(function* () { for (const [key, of] of $iter($m.items(row.sources))) { if (!(($in(key, $c2a894)))) continue; yield [key, of]; } })()]);
}
function drive_build___without(sources, key) {
return $map([...(function* () { for (const [name, of] of $iter($m.items(sources))) { if (!((!$eq(name, key)))) continue; yield [name, of]; } })()]);
}
function drive_build___preset_mass(record, preset) {
let carry, own, pulley;

([pulley, carry] = (function* () { for (const key of $iter(["pulley_cover", "carry_cover"])) { yield $m.get(record, key, $b.getattr(preset, key)); } })());
(own = $common(new Set(["carcass", "cord_diameter", "mass"]), new Set([...$iter(record)])));
if (((!$in("width", record)) || (pulley == null) || (carry == null) || $truth(own))) {
return null;
}
return belt_mass__layer_mass(preset, $at(record, "width"), pulley, carry);
}
function belt_mass__layer_mass(row, width, pulley_cover, carry_cover) {

if (((row.carcass_mass == null) || (row.cover_mass == null))) {
return null;
}
return $mul(width, $add(row.carcass_mass, $mul(row.cover_mass, $add(pulley_cover, carry_cover))));
}
function belt_mass__layer_source(row) {
let notes, origin;

(origin = $m.get(row.sources, "carcass_mass", $m.get(row.sources, "carcass", $bound(row, "provenance"))));
(notes = ["computed from carcass and covers", origin.note]);
if ($truth($m.startswith(origin.note, "estimated"))) {
(notes = [origin.note, "computed from carcass and covers"]);
}
return $replaced(origin, new Map([["note", $m.join("; ", notes)]]));
}
function drive_build___modulus_of_elongation(record, named, report) {
let of, place, remedy, strength;

(place = [...$iter(record.place), "elongation"]);
if (($in("modulus", record))) {
report.add(place, "modulus gives it already", "Leave one of them out.");
return null;
}
(strength = $m.get(record, "strength", $m.get(named, "strength")));
if ((strength == null)) {
(remedy = "Write strength = \"630 kN/m\", or name the belt EP 630/3.");
if ($truth(record.sound("strength"))) {
report.add(place, "needs the strength of the belt", remedy);
}
return null;
}
(of = $at(record, "elongation"));
return $map([["modulus", ($mul(of.share, strength) / of.strain)], ["modulus_test", "static"], ["modulus_loads", [0.0, of.share]], ["modulus_ends", null]]);
}
function drive_file___name_pulley(pulleys, report) {
let hint, own;

if ((($eq($b.len(pulleys), 1)) && ($in("name", $at(pulleys, 0))))) {
([hint, own] = [("" + "pulley." + $str("NAME") + "."), ("" + $str(problems__place_text(["pulley", $at($at(pulleys, 0), "name")])) + ".")]);
(report.problems = [...(function* () { for (const problem of $iter(report.problems)) { yield $replaced(problem, new Map([["remedy", $m.replace(problem.remedy, hint, own)]])); } })()]);
}
}
function problems__place_text(place) {
let key, step, text;

(text = "");
for (step of $iter(place)) {
if ($truth($b.isinstance(step, "int"))) {
(text = $add(text, ("" + "[" + $str(step) + "]")));
continue;
}
(key = ($truth($m.fullmatch($ca366, step)) ? step : $shown(step)));
(text = $add(text, ($truth(text) ? ("" + "." + $str(key)) : key)));
}
return text;
}
function conditions__build_conditions(record, report) {
let cases, main, problem, rows;

(rows = [...(function* () { for (const row of $iter($m.get(record, "condition", []))) { if (!((row !== $ca9ba))) continue; yield row; } })()]);
(main = [...(function* () { for (const row of $iter(rows)) { yield [conditions__condition_of(row, report), ["condition"]]; } })()]);
for (problem of $iter(drive__repeated("condition", (function* () { for (const [condition, _] of $iter(main)) { yield condition.name; } })()))) {
report.take(new InputError(problem), []);
}
(cases = [...(function* () { for (const case_ of $iter($or($m.get(record, "load_case"), () => []))) { if (!(($truth($b.isinstance(case_, Record)) && ($in("condition", case_))))) continue; yield [conditions__condition_of($at(case_, "condition"), report), [...$iter(case_.place), "condition"]]; } })()]);
return new Conditions($b.tuple(main), $b.tuple(cases));
}
function conditions__condition_of(value, report) {
let factors, made, source;

if (!$truth($b.isinstance(value, Record))) {
return new Condition($b.str(value));
}
(factors = $m.get(value, "friction_factors", $map([])));
(source = $or(origins__own_provenance(value, report), () => new Provenance()));
(made = $method($c0bb9, "built", [value, report], [["factors", factors], ["source", source]]));
return $or(made, () => new Condition($b.str($m.get(value, "name", "dry"))));
}
function drive__repeated(key, names) {
let found;

(found = $b.list(names));
if (($eq($b.len($b.set(found)), $b.len(found)))) {
return [];
}
return [...(function* () { for (const [name, count] of $iter($m.items($b.Counter(found)))) { if (!((count > 1))) continue; yield new Problem(("" + "used " + $str(count) + " times"), "Give each its own name.", undefined, ("" + $str(key) + ".name"), $shown(name)); } })()];
}
function drive_build__build_pulley(record, laggings, conditions, report) {
let built, by_name, found, found_before, lagging, laws, more, own, place, sources, sure, uncertainty, wrap;

(sources = origins__read_sources(record, (function* () { for (const e of $iter($c06ce)) { yield e.key; } })(), report));
(uncertainty = uncertain__read_uncertainty(record, $c2e28, report));
(laws = []);
if (($in("lagging", record))) {
(laws = laggings.of($at(record, "lagging"), [...$iter(record.place), "lagging"]));
}
if (!$truth(laws)) {
return null;
}
(own = [...(function* () { for (const [c, place] of $iter($slice(conditions.main, null, 1))) { yield [c, place]; } })()]);
if (($in("condition", record))) {
(place = [...$iter(record.place), "condition"]);
(own = [[conditions__condition_of($at(record, "condition"), report), place]]);
}
(found = [...(function* () { for (const [c, place] of $iter([...$iter(own), ...$iter(conditions.several)])) { yield report.tried((() => conditions__at_its_place(c, laws)), place); } })()]);
(sure = [...(function* () { for (const lagging of $iter(found)) { if (!((lagging != null))) continue; yield lagging; } })()]);
if (($b.len(sure) < $b.len(found))) {
return null;
}
(lagging = ($truth(own) ? $at(sure, 0) : $at(laws, 0)));
(by_name = $map([...(function* () { for (const lag of $iter($slice(sure, $b.len(own), null))) { yield [lag.condition, lag]; } })()]));
(more = $map([["conditions", $b.tuple($m.values(by_name))], ["uncertainty", uncertainty]]));
if (($in("belt_path", record))) {
(wrap = drive_build___wrap_of(record, report));
if ((wrap == null)) {
return null;
}
{ const [$v0, $v1] = [wrap, $map([["wrap_angle", $c2aaf], ...sources])]; $put(more, "wrap_angle", $v0); (sources = $v1); }
}
if (($in("across", record))) {
(found_before = $b.len($bound(report, "problems")));
$put(more, "across", across_keys__build_across($at(record, "across"), report));
if (($b.len($bound(report, "problems")) > found_before)) {
return null;
}
}
(built = $method($c706c, "built", [record, report], [["lagging", lagging], ["sources", sources], ...more]));
return built;
}
function conditions__at_its_place(condition, laws) {
let error;

try {
return condition.of(laws);
} catch ($error) {
if ($error instanceof InputError) {
error = $error;
throw new InputError((function* () { for (const p of $iter(error.problems)) { yield $replaced(p, new Map([["key", ""], ["value", $shown($bound(condition, "name"))]])); } })());
} else throw $error;
}
}
function drive_build___wrap_of(record, report) {
let own, path, remedy;

(path = $at(record, "belt_path"));
if (($in("wrap_angle", record))) {
(remedy = "Leave one of them out.");
report.add([...$iter(record.place), "wrap_angle"], "belt_path gives it already", remedy);
return null;
}
if ((!$truth($b.isinstance(path, Record)) || !$truth(path.sound()) || (!$in("diameter", record)))) {
return null;
}
function point(given, more = new Map()) {
return $call(Point, [], [...$map([...(function* () { for (const key of $iter($c39fc)) { if (!(($in(key, given)))) continue; yield [key, $at(given, key)]; } })()]), ...more]);
}
$sig(point, ["given"], true);
(own = $call(point, [path], [["diameter", $at(record, "diameter")]]));
return report.tried((() => belt_path__wrap_angle(point($at(path, "before")), own, point($at(path, "after")))), $bound(path, "place"));
}
function belt_path__wrap_angle(before, pulley, after) {

limits__raise_all(belt_path__overlaps(before, pulley, after));
return belt_path__turned_by(before, pulley, after);
}
function belt_path__overlaps(before, pulley, after) {
let distance, end, key, message, problems, remedy;

(problems = []);
for ([end, key] of $iter([[before, "before"], [after, "after"]])) {
(distance = $math.hypot($sub(end.x, pulley.x), $sub(end.y, pulley.y)));
if (((distance < ($add(end.diameter, pulley.diameter) / 2.0)) || ($eq(distance, 0.0)))) {
(message = ("" + "overlaps the pulley: their centres are " + $str(display__display(distance, "length")) + " apart"));
(remedy = "Check the coordinates and the diameters.");
$m.append(problems, new Problem(message, remedy, undefined, key));
}
}
return problems;
}
function display__display(value, dimension, system = "si", digits = 4) {

return display__joined(display__parts(value, dimension, system, digits));
}
function display__parts(value, dimension, system, digits) {
let bound, factor, number, other, row, size, unit, zero;

(row = $once(display__unit_row, $kept_display__unit_row)(dimension, system));
([unit, number] = [row.unit, (value / row.factor)]);
if ((($b.abs(number) < 1e-09) && (!$eq(dimension, "wear_coefficient")))) {
(number = 0.0);
}
(size = $b.abs(digits__read(digits__rounded(number, digits))));
for ([bound, other, factor, zero] of $iter(row.larger)) {
if ((bound <= size && size < Infinity)) {
([unit, number] = [other, ($sub(value, zero) / factor)]);
}
}
return [digits__rounded(number, digits), unit];
}
function display__unit_row(dimension, system) {
let larger, more, one, unit, zero;

([unit, more] = $at($at($cd5a9, system), dimension));
if (($eq(dimension, "temperature"))) {
(zero = parse__parse_quantity(("" + "0 " + $str(unit)), dimension));
(one = parse__parse_quantity(("" + "1 " + $str(unit)), dimension));
return new UnitRow("K", 1.0, [[0.0, unit, $sub(one, zero), zero]]);
}
(larger = $b.tuple((function* () { for (const [bound, name] of $iter(more)) { yield [bound, name, parse__unit_factor(name, dimension), 0.0]; } })()));
return new UnitRow(unit, parse__unit_factor(unit, dimension), larger);
}
const $kept_display__unit_row = new Map();
function digits__rounded(number, digits) {
let given, power, text;

if ($truth($math.isnan(number))) {
return "nan";
}
if ($truth($math.isinf(number))) {
return ((number > 0.0) ? "inf" : "-inf");
}
if (($eq(number, 0.0))) {
return "0";
}
(given = digits__scientific(number, $sub(4, 1)));
(power = digits__exponent_of(given));
if (((digits <= 4) && $truth(digits___equal(digits__read(given), number)) && ($neg(4) <= power && power < 12))) {
return digits__trimmed(digits__fixed(digits__read(given), $b.max(0, $sub($sub(4, 1), power))));
}
(text = digits__scientific(number, $sub(digits, 1)));
(power = digits__exponent_of(text));
return (($neg(4) <= power && power < 12) ? digits__fixed(digits__read(text), $b.max(0, $sub($sub(digits, 1), power))) : text);
}
function digits__scientific(number, digits) {

return ("" + $format(number, ("" + "." + $str(digits) + "e")));
}
function digits__exponent_of(text) {

return $b.int($at($m.rpartition(text, "e"), 2));
}
function digits__read(text) {

return $b.float(text);
}
function digits___equal(a, b) {
return ($b.abs($sub(a, b)) <= $mul(1e-09, $b.max($b.abs(a), $b.abs(b))));
}
function digits__fixed(number, digits) {

return ("" + $format(number, ("" + "." + $str(digits) + "f")));
}
function digits__trimmed(text) {

return (($in(".", text)) ? $m.rstrip($m.rstrip(text, "0"), ".") : text);
}
function display__joined(of) {
let number, unit;

([number, unit] = of);
return $add(number, ((!$eq(unit, "")) ? $add(" ", unit) : ""));
}
function limits__raise_all(problems) {

if ($truth(problems)) {
throw new InputError(problems);
}
}
function belt_path__turned_by(before, pulley, after) {
let incoming, outgoing, turned;

([incoming, outgoing] = [belt_path___direction(before, pulley), belt_path___direction(pulley, after)]);
(turned = (($eq(pulley.turn, "counterclockwise")) ? $sub(outgoing, incoming) : $sub(incoming, outgoing)));
(turned = (turned % 6.283185307179586));
return (($sub(6.283185307179586, turned) < 1e-09) ? 0.0 : turned);
}
function belt_path___direction(start, end) {
let dx, dy, offset;

([dx, dy] = [$sub(end.x, start.x), $sub(end.y, start.y)]);
(offset = $sub(end.side, start.side));
return $sub($math.atan2(dy, dx), $math.asin((offset / $math.hypot(dx, dy))));
}
function across_keys__build_across(record, report) {
let built, ends;

if (!$truth($b.isinstance(record, Record))) {
return null;
}
(ends = $map([...(function* () { for (const [key, kind] of $iter([["before", $c5ba2], ["after", $c5263]])) { if (!($truth($b.isinstance($m.get(record, key), Record)))) continue; yield [key, kind.built($at(record, key), report)]; } })()]));
(built = $method($c7a37, "built", [record, report], [...ends]));
return built;
}
function across_keys__check_width(pulleys, belt, report) {
let across, key, problem, profile, pulley;

if ((!$truth($b.isinstance(belt, Record)) || (!$in("width", belt)))) {
return null;
}
for (pulley of $iter(pulleys)) {
(across = $m.get(pulley, "across"));
if (!$truth($b.isinstance(across, Record))) {
continue;
}
for ([key, profile] of $iter($m.items(across))) {
if ($truth($b.isinstance(profile, WidthProfile))) {
for (problem of $iter(profile.problems("", $at(belt, "width")))) {
report.take(new InputError(problem), [...$iter(across.place), key]);
}
}
}
}
}
function tensions__report_uncertain_twice(record, report) {
let every, given, key, message, place, pulley, table;

for (table of $iter(["train", "conveyor"])) {
(every = $m.get(record, table));
if ((!$truth($b.isinstance(every, Record)) || !$truth($m.get(every, "uncertainty")))) {
continue;
}
for (pulley of $iter($or($m.get(record, "pulley"), () => []))) {
if (!$truth($b.isinstance(pulley, Record))) {
continue;
}
(given = $m.get(pulley.raw, "uncertainty", $map([])));
for (key of $iter($m.get(pulley, "uncertainty", $map([])))) {
if (($in(key, $c6fe1))) {
(message = ("" + "contradicts those of [" + $str(table) + "]"));
(place = [...$iter(pulley.place), "uncertainty", key]);
report.add(place, message, "Remove one of them.", $at(given, key));
}
}
}
}
}
function drive_build__build_criteria(record, belt, report) {
let parts;

(parts = $map([...(function* () { for (const e of $iter($cf50e)) { if (!((!$eq(e.key, "sag")))) continue; yield [e.attribute, e.kind.built($m.get(record, $bound(e, "key")), report)]; } })()]));
$put(parts, "sag", drive_build__build_sag($m.get(record, "sag"), drive_build___mass(record, belt), report));
return $call(Criteria, [], [...$map([...(function* () { for (const [name, part] of $iter($m.items(parts))) { if (!((part != null))) continue; yield [name, part]; } })()])]);
}
function drive_build___mass(record, belt) {
let conveyor, of_conveyor;

(conveyor = $m.get(record, "conveyor"));
(of_conveyor = null);
if (($truth($b.isinstance(conveyor, Record)) && ($in("belt_mass", conveyor)))) {
(of_conveyor = $at(conveyor, "belt_mass"));
}
return (((belt != null) && (of_conveyor == null)) ? belt.mass : of_conveyor);
}
function drive_build__build_sag(record, mass, report) {
let built, more, remedy;

if (!$truth($b.isinstance(record, Record))) {
return null;
}
(more = $map([]));
if (!$truth($common(new Set(["line_mass"]), new Set([...$iter(record), ...$iter(record.faulty)])))) {
if ((mass == null)) {
(remedy = "Write for example line_mass = \"22 kg/m\", or mass in [belt].");
report.add([...$iter(record.place), "line_mass"], "missing", remedy);
return null;
}
$put(more, "line_mass", mass);
}
(built = $method($c9f3b, "built", [record, report], [...more]));
return built;
}
function drive_file___load_cases(record, pulleys, built_belt, take_up, report) {
let belt, built, case_, cases, given, more, names, own, problem, speed, sure, tensions, whole;

(belt = $m.get(record, "belt"));
(names = [...(function* () { for (const item of $iter(pulleys)) { if (!(($in("name", item)))) continue; yield $at(item, "name"); } })()]);
(cases = [...(function* () { for (const item of $iter($or($m.get(record, "load_case"), () => []))) { if (!($truth($b.isinstance(item, Record)))) continue; yield item; } })()]);
for (problem of $iter(drive__repeated("pulley", names))) {
report.take(new InputError(problem), []);
}
if ((!$truth(names) || ($b.len($b.set(names)) < $b.len($at(record, "pulley"))) || !$truth($b.isinstance(belt, Record)))) {
return [];
}
(sure = $and(belt.sound("speed"), () => $b.all((function* () { for (const item of $iter(pulleys)) { yield item.sound(...$iter($c6fe1)); } })())));
(speed = $m.get(belt, "speed"));
(own = [...(function* () { for (const item of $iter(pulleys)) { yield Given.of($at(item, "name"), item, drive_file___pulled_at(item, built_belt)); } })()]);
(built = []);
if ((!$truth(cases) || $truth(tensions__complete(own, speed)))) {
(tensions = tensions__resolve(own, speed, report, sure));
$m.append(built, new LoadCase("design", tensions));
(sure = $and(sure, () => ($eq($b.len(tensions), $b.len(own)))));
}
for (case_ of $iter(cases)) {
if (($in("train", case_))) {
report.add([...$iter(case_.place), "train"], "there is no [train] table", "Write one.");
}
(given = drive_file___of_case(case_, own, take_up, speed, report));
(whole = $and(sure, () => case_.sound()));
(tensions = tensions__resolve(given, speed, report, whole));
if (($in("name", case_))) {
(more = $map([["kind", $m.get(case_, "kind", "running")], ["condition", conditions__condition_name(case_)]]));
$put(more, "description", $m.get(case_, "description", ""));
$put(more, "uncertainty", drive_file___uncertainty_of(case_, report));
$m.append(built, $call(LoadCase, [], [["name", $at(case_, "name")], ["tensions", tensions], ...more]));
}
}
for (problem of $iter(drive__repeated("load_case", (function* () { for (const case_ of $iter(built)) { yield case_.name; } })()))) {
report.take(new InputError(problem), []);
}
return $b.tuple(built);
}
function drive_file___pulled_at(pulley, belt) {
let diameter;

(diameter = $m.get(pulley, "diameter"));
if (((diameter == null) || (belt == null))) {
return diameter;
}
return $add(diameter, $mul(2.0, $or(pitch__pitch_offset(belt, $m.get(pulley, "side", "pulley")), () => 0.0)));
}
function pitch__pitch_offset(belt, side) {
let found;

(found = pitch__tension_offset(pitch__layers_of(belt), ($eq(side, "carry"))));
return ($truth($math.isnan(found)) ? null : found);
}
function pitch__layers_of(belt) {
let given;

(given = [belt.pulley_cover, belt.carry_cover, belt.cord, belt.thickness]);
return pitch__layers(...$iter((function* () { for (const value of $iter(given)) { yield ((value == null) ? NaN : value); } })()));
}
function pitch__layers(pulley_cover, carry_cover, carcass, thickness) {
let known;

(known = ($eq(thickness, thickness)));
if (($truth(known) && $truth($math.isnan(carcass)))) {
return new Layers(pulley_cover, carry_cover, $sub($sub(thickness, pulley_cover), carry_cover));
}
if (($truth(known) && $truth($math.isnan(carry_cover)))) {
return new Layers(pulley_cover, $sub($sub(thickness, pulley_cover), carcass), carcass);
}
if (($truth(known) && $truth($math.isnan(pulley_cover)))) {
return new Layers($sub($sub(thickness, carry_cover), carcass), carry_cover, carcass);
}
return new Layers(pulley_cover, carry_cover, carcass);
}
function pitch__tension_offset(of, carries) {

return $add(pitch__touching_cover(of, carries), $mul(0.5, of.carcass));
}
function pitch__touching_cover(of, carries) {

return ($truth(carries) ? of.carry_cover : of.pulley_cover);
}
function tensions__complete(given, speed) {

return $b.all((function* () { for (const pair of $iter(tensions__spread(given, speed))) { yield (!$in(null, pair)); } })());
}
function tensions__spread(given, speed) {
let _, entry, i, leaving, pairs, pull, pulls;

(pairs = [...(function* () { for (const item of $iter(given)) { yield new NipTensions($bound(item.values, "entry_tension"), $bound(item.values, "exit_tension")); } })()]);
(pulls = [...(function* () { for (const item of $iter(given)) { yield tension_rules__pull_given($bound(item, "values"), item.at(speed)); } })()]);
for (_ of $iter($b.range($mul(2, $b.len(pairs))))) {
for ([i, pull] of $iter($b.enumerate(pulls))) {
([entry, leaving] = tension_rules__filled(...$iter($at(pairs, i)), pull));
if (((entry == null) && (i > 0))) {
([entry, leaving] = tension_rules__filled($bound($at(pairs, $sub(i, 1)), "exit"), leaving, pull));
}
if (((leaving == null) && ($add(i, 1) < $b.len(pairs)))) {
([entry, leaving] = tension_rules__filled(entry, $bound($at(pairs, $add(i, 1)), "entry"), pull));
}
$put(pairs, i, new NipTensions(entry, leaving));
}
}
return pairs;
}
function tensions__resolve(given, speed, report, sure = true) {
let entry, exit_, fault, item, made, place, tensions, wrong;

(wrong = [...(function* () { for (const item of $iter(given)) { if (!(($truth(sure) || !$truth(item.inherited)))) continue; yield tensions___wrong(item, speed, report); } })()]);
if ($truth($b.any(wrong))) {
return $map([]);
}
for (item of $iter(($truth(sure) ? given : []))) {
(fault = tension_rules__speed_missing($bound(item, "values"), item.at(speed)));
if ($truth(fault)) {
(place = (($in(fault.lacks, item.inherited)) ? item.place : [...$iter(item.place), fault.lacks]));
report.add(place, $bound(fault, "message"), $bound(fault, "remedy"));
(sure = false);
}
}
if ($truth($b.any((function* () { for (const item of $iter(given)) { yield $and((item.diameter == null), () => (item.values.torque != null)); } })()))) {
(sure = false);
}
(tensions = $map([]));
for ([item, [entry, exit_]] of $iter($b.zip(given, tensions__spread(given, speed), $k({strict: true})))) {
if (((entry == null) || (exit_ == null))) {
if ($truth(sure)) {
(fault = tension_rules__too_few($bound(item, "values")));
$method(report, "add", [$bound(item, "place"), $bound(fault, "message"), $bound(fault, "remedy")], [["code", "few_tensions"]]);
}
} else {
if ($truth((made = tensions___made(item, entry, exit_, report)))) {
$put(tensions, item.name, made);
}
}
}
return tensions;
}
function tensions___wrong(item, speed, report) {
let fault;

(fault = tension_rules__fault_of($bound(item, "values"), $b.bool($bound(item, "inherited")), item.at(speed), tensions___force));
if ($truth(fault)) {
report.add($bound(item, "place"), $bound(fault, "message"), $bound(fault, "remedy"));
}
return fault;
}
function tensions___force(value) {
return display__display(value, "force");
}
function tensions___made(item, entry, exit_, report) {
let key, made, message, place, pulls, remedy, side, tension, told, why;
(pulls = tension_rules__effective_keys($bound(item, "values")));
try {
(told = $m.join(" and ", (function* () { for (const key of $iter(pulls)) { yield $m.strip(("" + $str($m.replace(key, "_", " ")) + " " + $str($m.get(item.raw, key, "")))); } })()));
(why = ($truth(told) ? ("" + "computed from " + $str(told)) : "that of the neighbouring pulley"));
(made = $map([...(function* () { for (const [key, name] of $iter($m.items($c7939))) { if (!(($b.getattr($bound(item, "values"), name) == null))) continue; yield [key, why]; } })()]));
return new Tensions(entry, exit_, made);
} catch ($error) {
if ($error instanceof InputError) {
([side, tension] = ((exit_ <= 0.0) ? ["exit", exit_] : ["entry", entry]));
(key = $b.next((function* () { for (const k of $iter(pulls)) { if (!((!$in(k, item.inherited)))) continue; yield k; } })(), ""));
(place = ($truth(key) ? [...$iter(item.place), key] : item.place));
(message = ("" + "leaves an " + $str(side) + " tension of " + $str(display__display(tension, "force"))));
(remedy = "Lower Te, or raise T2.");
report.add(place, message, remedy, ...$iter(($truth(key) ? [$at(item.raw, key)] : [])));
return null;
} else throw $error;
}
}
function drive_file___of_case(case_, own, take_up, speed, report) {
let given, item, name, names, over, place, table, tables;

(tables = $m.get(case_, "pulley", $map([])));
(names = [...(function* () { for (const item of $iter(own)) { yield item.name; } })()]);
for (name of $iter(($truth(own) ? tables : []))) {
if ((!$in(name, names))) {
(place = [...$iter(case_.place), "pulley", name]);
report.add(place, "no such pulley", errors__name_remedy(name, names));
}
}
(given = []);
for (item of $iter(own)) {
(table = $m.get(tables, $bound(item, "name")));
(place = [...$iter(case_.place), "pulley", item.name]);
(over = ($truth($b.isinstance(table, Record)) ? table : new Record($map([]), place, $map([]))));
$m.append(given, $method(item, "overridden", [over], [["fixed", take_up.fixed], ["speed", speed]]));
}
return given;
}
function errors__name_remedy(given, known) {
let listed, names;

(names = $b.list(known));
(listed = ($truth(names) ? ("" + "Write one of " + $str(errors__format_names(names)) + ".") : ""));
return $or(errors__nearest(given, names), () => listed);
}
function errors__format_names(names, most = 6) {

return errors__format_list([...(function* () { for (const name of $iter(names)) { yield $shown(name); } })()], most);
}
function conditions__condition_name(case_) {
let value;

(value = $m.get(case_, "condition", ""));
return ($truth($b.isinstance(value, Record)) ? $b.str($m.get(value, "name", "")) : $b.str(value));
}
function drive_file___uncertainty_of(case_, report) {
let found, name, of, table;

(found = $map([]));
for ([name, table] of $iter($m.items($m.get(case_, "pulley", $map([]))))) {
if ($truth($b.isinstance(table, Record))) {
(of = uncertain__read_uncertainty(table, $c26fe, report));
if ($truth(of)) {
$put(found, name, of);
}
}
}
return found;
}
function conveyor_build__build_conveyor(record, belt, take_up, report) {
let conveyor, given, message, pulleys, states;

if (($b.len($or($m.get(record, "pulley"), () => [])) > 1)) {
(message = ("" + "has " + $str($b.len($at(record, "pulley"))) + " drive pulleys and no [train] with their shares"));
report.add(["conveyor"], message, "Write share = [\"50 %\", \"50 %\"] in [train].");
}
(conveyor = conveyor_build__described_conveyor(record, belt, take_up, report));
(given = $m.get(record, "conveyor"));
(pulleys = [...(function* () { for (const item of $iter($or($m.get(record, "pulley"), () => []))) { if (!($truth($b.isinstance(item, Record)))) continue; yield item; } })()]);
if (((conveyor == null) || !$truth($b.isinstance(given, Record)) || ($b.len(pulleys) > 1))) {
return [null, []];
}
(states = report.tried($bound(conveyor, "states"), $bound(given, "place"), $bound(given, "raw")));
if ((!$truth(states) || !$truth(pulleys) || (!$in("name", $at(pulleys, 0))))) {
return [conveyor, []];
}
return [conveyor, conveyor_build__load_cases(conveyor, states, $at($at(pulleys, 0), "name"))];
}
function conveyor_build__described_conveyor(record, belt, take_up, report) {
let given, mass, message, more, names, pulleys, remedy;

(pulleys = [...(function* () { for (const item of $iter($or($m.get(record, "pulley"), () => []))) { if (!($truth($b.isinstance(item, Record)))) continue; yield item; } })()]);
conveyor_build___refuse_tensions(record, pulleys, report);
if ($truth(take_up.fixed)) {
(message = "a fixed take-up does not go with [conveyor]");
(remedy = "Give tensions of each load case.");
report.add(["take_up", "kind"], message, remedy, $bound(take_up, "kind"));
}
(given = $m.get(record, "conveyor"));
if (!$truth($b.isinstance(given, Record))) {
return null;
}
if (($truth(take_up.after) && ($eq($b.len(pulleys), 1)))) {
(message = "contradicts take_up_distance of [conveyor]");
report.add(["take_up", "after"], message, "Leave it out.", $bound(take_up, "after"));
}
(mass = ((belt == null) ? null : belt.mass));
(names = [...(function* () { for (const pulley of $iter(pulleys)) { if (!(($in("name", pulley)))) continue; yield $at(pulley, "name"); } })()]);
(more = $merged(conveyor_build___of_belt(belt), conveyor_build___parts(given, names, take_up, report)));
return conveyor_build___conveyor(given, $m.get(record, "belt"), mass, take_up, more, report);
}
function conveyor_build___refuse_tensions(record, pulleys, report) {
let key, message, pulley, remedy;

for (pulley of $iter(pulleys)) {
for (key of $iter((function* () { for (const key of $iter($c6fe1)) { if (!(($in(key, pulley)))) continue; yield key; } })())) {
report.add([...$iter(pulley.place), key], "the [conveyor] table gives the tensions already", "Leave it out, or the [conveyor] table.", $at(pulley.raw, key));
}
}
if (($in("load_case", record))) {
(message = "the [conveyor] table gives the load cases already");
(remedy = "Write [[conveyor.load_case]] for those of its own, or leave one of them out.");
report.add(["load_case"], message, remedy);
}
}
function conveyor_build___of_belt(belt) {

if ((belt == null)) {
return $map([]);
}
return $map([["width", belt.width], ["thickness", conveyor_build___thickness(belt)], ["steel", ($eq(belt.kind, "steel-cord"))]]);
}
function conveyor_build___thickness(belt) {
let known, layers;

(layers = [belt.pulley_cover, belt.carry_cover, belt.cord]);
(known = [...(function* () { for (const layer of $iter(layers)) { if (!((layer != null))) continue; yield layer; } })()]);
if (((belt.thickness != null) || ($b.len(known) < $b.len(layers)))) {
return belt.thickness;
}
return $b.sum(known);
}
function conveyor_build___parts(given, names, take_up, report) {
let cases, field, key, made, parts, table;

(parts = $map([]));
for ([key, table, field] of $iter($ca4a5)) {
(made = [...(function* () { for (const row of $iter(conveyor_build___tables(given, key))) { yield table.built(row, report); } })()]);
(parts = $merged(parts, conveyor_build___whole(given, key, field, made)));
}
(cases = [...(function* () { for (const row of $iter(conveyor_build___tables(given, "load_case"))) { yield conveyor_build___case(row, report); } })()]);
(parts = $merged(parts, conveyor_build___whole(given, "load_case", "cases", cases)));
for ([key, table] of $iter([["travel", $c9244], ["cema", $cf8a9]])) {
if ($truth($b.isinstance($m.get(given, key), Record))) {
$put(parts, key, table.built($at(given, key), report));
}
}
return $merged($merged(parts, conveyor_build___drives(given, parts, names, take_up, report)), conveyor_build___sums(given, parts));
}
function conveyor_build___tables(given, key) {

return [...(function* () { for (const row of $iter($or($m.get(given, key), () => []))) { if (!($truth($b.isinstance(row, Record)))) continue; yield row; } })()];
}
function conveyor_build___whole(given, key, field, made) {

if ($truth($b.any((function* () { for (const one of $iter(made)) { yield (one == null); } })()))) {
given.faulty.add(key);
}
return (($b.len(made) > 0) ? $map([[field, $b.tuple(made)]]) : $map([]));
}
function conveyor_build___case(row, report) {
let case_, factors;
(factors = $b.dict($or($m.get(row, "factor"), () => $map([]))));
(case_ = $method($c1695, "built", [row, report], [["factor", factors]]));
return case_;
}
function conveyor_build___drives(given, parts, names, take_up, report) {
let at, found;

(found = (($b.len(names) > 1) ? $map([["take_up_after", take_up.after]]) : $map([])));
if (($in("drive", given.faulty))) {
return found;
}
if (($in("drives", parts))) {
return $merged(found, $map([["drives", conveyor_build___placed(given, $at(parts, "drives"), names, report)]]));
}
if ((($b.len(names) > 1) || ($in("flights", parts)))) {
(at = $m.get(given, "drive_at", "head"));
return $merged(found, $map([["drives", $b.tuple((function* () { for (const name of $iter(names)) { yield new DrivePlace(name, at); } })())]]));
}
return found;
}
function conveyor_build___placed(given, drives, names, report) {
let by_name, drive, i, message, name, place, remedy;

(by_name = $map([...(function* () { for (const drive of $iter(drives)) { yield [drive.pulley, drive]; } })()]));
for ([i, drive] of $iter($b.enumerate(drives))) {
if ((!$in(drive.pulley, names))) {
(place = [...$iter(given.place), "drive", $add(i, 1), "pulley"]);
report.add(place, "no such pulley", errors__name_remedy($bound(drive, "pulley"), names), $bound(drive, "pulley"));
given.faulty.add("drive");
}
}
for (name of $iter(names)) {
if ((!$in(name, by_name))) {
(message = ("" + "pulley " + $str(name) + " is at no place"));
(remedy = ("" + "Write a [[conveyor.drive]] with pulley = \"" + $str(name) + "\" and at."));
report.add([...$iter(given.place), "drive"], message, remedy);
given.faulty.add("drive");
}
}
return $b.tuple((function* () { for (const name of $iter(names)) { if (!(($in(name, by_name)))) continue; yield $at(by_name, name); } })());
}
function conveyor_build___sums(given, parts) {
let flights, sums;

(flights = $m.get(parts, "flights", []));
if ((($eq($b.len(flights), 0)) || ($in(null, flights)))) {
return $map([]);
}
(sums = $map([["length", $b.sum((function* () { for (const flight of $iter(flights)) { yield flight.length; } })())], ["lift", $b.sum((function* () { for (const flight of $iter(flights)) { yield flight.rise; } })())]]));
return $map([...(function* () { for (const [key, value] of $iter($m.items(sums))) { if (!((!$in(key, new Set([...$iter(given), ...$iter(given.faulty)]))))) continue; yield [key, value]; } })()]);
}
function conveyor_build___conveyor(given, belt, mass, take_up, parts, report) {
let conveyor, more, speed, told, unsure;
(more = $map([["sheave_ratio", take_up.sheave_ratio], ...parts]));
$put(more, "uncertainty", uncertain__read_uncertainty(given, $cac72, report));
if (!$truth($common(new Set(["belt_mass"]), new Set([...$iter(given), ...$iter(given.faulty)])))) {
$put(more, "belt_mass", mass);
if ((mass == null)) {
given.faulty.add("belt_mass");
if ((!$truth($b.isinstance(belt, Record)) || $truth(belt.sound("mass")))) {
report.add([...$iter(given.place), "belt_mass"], "missing", "Write for example belt_mass = \"22 kg/m\", or mass in [belt].");
}
}
}
(speed = ($truth($b.isinstance(belt, Record)) ? $m.get(belt, "speed") : null));
if ((speed != null)) {
$put(more, "speed", speed);
}
(unsure = $or(!$truth($b.isinstance(belt, Record)), () => !$truth(belt.sound("speed"))));
if (($truth(given.sound()) && !$truth(unsure))) {
(conveyor = $method($ca5a9, "built", [given, report], [...more]));
return conveyor;
}
(told = choices__choices(new Set([...$iter(given), ...$iter(given.faulty), ...$iter(more), ...$iter(($truth(unsure) ? ["speed"] : []))])));
if ($truth(told)) {
report.take(new InputError(told), $bound(given, "place"), $bound(given, "raw"));
}
return null;
}
function choices__choices(given) {
let both, example, first, key, loads, message, problems, remedy, second;

(problems = []);
(loads = ($in("loading", given)));
for ([first, second, example] of $iter($c601c)) {
if (($truth(loads) && ($eq(second, "capacity")))) {
(both = [...(function* () { for (const key of $iter([first, second])) { if (!(($in(key, given)))) continue; yield key; } })()]);
([message, remedy] = ["means the same as [[conveyor.loading]]", "Leave one of them out."]);
(problems = $add(problems, [...(function* () { for (const key of $iter(both)) { yield new Problem(message, remedy, undefined, key); } })()]));
continue;
}
if ((($in(first, given)) && ($in(second, given)))) {
(message = ("" + "means the same as " + $str(first)));
$m.append(problems, new Problem(message, "Leave one of them out.", undefined, second));
} else {
if (((!$eq(example, "")) && (!$in(first, given)) && (!$in(second, given)))) {
(remedy = ("" + "Write " + $str(example) + ", or " + $str(second) + "."));
$m.append(problems, new Problem("missing", remedy, undefined, first, undefined, undefined, "missing"));
}
}
}
for (key of $iter($c361e)) {
if ((($in(key, given)) && (!$in("speed", given)))) {
(remedy = "Write speed = \"3 m/s\" in [belt].");
$m.append(problems, new Problem("needs the belt speed", remedy, undefined, key));
}
}
return problems;
}
function conveyor_build__load_cases(conveyor, states, pulley) {
let every;

(every = uncertain__uncertain_tensions(conveyor, states));
return $b.tuple((function* () { for (const [state, of] of $iter($b.zip(states, every, $k({strict: true})))) { yield conveyor_build__load_case(state, pulley, of); } })());
}
function uncertain__uncertain_tensions(conveyor, states) {
let end, found, i, key, lift, moved, of, pull, slope, squares, state, stated, step, value;

([squares, lift] = [[...(function* () { for (const _ of $iter(states)) { yield 0.0; } })()], 0.0]);
(stated = [...(function* () { for (const key of $iter(conveyor.uncertainty)) { if (!((!$in(key, $cdeee)))) continue; yield key; } })()]);
for (key of $iter(conveyor.uncertainty)) {
(value = $at(conveyor.uncertainty, key));
if (($in(key, $cdeee))) {
(lift = $mul(value, conveyor.take_up));
continue;
}
([moved, step] = uncertain___moved(conveyor, key));
for (i of $iter($b.range($b.len(moved)))) {
(slope = ($sub(uncertain___pull($at(moved, i)), uncertain___pull($at(states, i))) / step));
$put(squares, i, $add($at(squares, i), $pow($mul(slope, value), 2)));
}
}
(found = []);
for (i of $iter($b.range($b.len(states)))) {
([state, of] = [$at(states, i), $b.dict()]);
(pull = $b.abs(uncertain___pull(state)));
if (($truth(stated) && (pull > 0.0))) {
$put(of, "effective_tension", $b.min(($math.sqrt($at(squares, i)) / pull), 1.0));
}
if (($b.len(stated) < $b.len($bound(conveyor, "uncertainty")))) {
(end = ((state.entry > state.exit) ? "exit_tension" : "entry_tension"));
$put(of, end, $b.min((lift / $b.min($bound(state, "entry"), $bound(state, "exit"))), 1.0));
}
$m.append(found, of);
}
return found;
}
function uncertain___moved(conveyor, key) {
let more, step;

for (step of $iter([0.001, $neg(0.001)])) {
(more = $map([[key, $mul($b.getattr(conveyor, key), $add(1.0, step))]]));
try {
return [$replaced(conveyor, new Map([...more])).states(), step];
} catch ($error) {
if ($error instanceof InputError) {
continue;
} else throw $error;
}
}
return [conveyor.states(), 1.0];
}
function uncertain___pull(state) {
return $sub(state.entry, state.exit);
}
function conveyor_build__load_case(state, pulley, uncertainty) {
let kind, made, stated, tensions, why;

(why = "computed from the resistances of the conveyor");
(made = $map([["entry", why], ["exit", why]]));
(tensions = new Tensions(state.entry, state.exit, made));
(kind = state.kind);
(stated = ($truth(uncertainty) ? $map([[pulley, uncertainty]]) : $map([])));
return new LoadCase(state.name, $map([[pulley, tensions]]), kind, undefined, undefined, stated);
}
function drive__least_tensions(cases) {

return $map([...(function* () { for (const case_ of $iter(cases)) { yield [("" + "load_case." + $str(case_.name)), $b.min((function* () { for (const t of $iter($m.values(case_.tensions))) { yield $b.min($bound(t, "entry"), $bound(t, "exit")); } })(), $k({default: Infinity}))]; } })()]);
}
function drive_build__report_together(record, belt, pulleys, tensions, report) {
let found;

if ((!$truth(report.problems) || (belt == null) || !$truth($b.isinstance(record, Record)))) {
return null;
}
(found = [...(function* () { for (const [key, least] of $iter($m.items(tensions))) { for (const p of $iter(drive__flying_problems(belt, key, least))) { yield p; }} })()]);
if ($truth(record.sound(...$iter($c2d22), "thickness"))) {
(found = $add(found, drive__side_problems(belt, [...(function* () { for (const pulley of $iter(pulleys)) { if (!((pulley != null))) continue; yield pulley; } })()])));
}
if ($truth(found)) {
report.take(new InputError(found), []);
}
}
function drive__flying_problems(belt, key, least) {
let force;

(force = pitch__centrifugal_of(belt));
if ((force < least)) {
return [];
}
return [new Problem(("" + "m v^2 = " + $str(display__display(force, "force")) + " of the belt exceeds its tension " + $str(display__display(least, "force"))), "Give the mass of one metre of belt.", undefined, key)];
}
function pitch__centrifugal_of(belt) {

if (((belt.mass == null) || (belt.speed == null))) {
return 0.0;
}
return pitch__centrifugal_force($bound(belt, "mass"), $bound(belt, "speed"));
}
function drive__side_problems(belt, pulleys) {

if ($truth($b.all((function* () { for (const key of $iter([...$iter($c2d22), "thickness"])) { yield ($b.getattr(belt, key) == null); } })()))) {
return [];
}
return [...(function* () { for (const pulley of $iter(pulleys)) { if (!((($eq(pulley.side, "carry")) && $truth($math.isnan(pitch__touching_cover(pitch__layers_of(belt), true)))))) continue; yield new Problem("needs carry_cover of the belt", "Write carry_cover = \"5 mm\" in [belt].", undefined, ("" + "pulley." + $str(pulley.name) + ".side"), $shown($bound(pulley, "side"))); } })()];
}
function conditions__in_each_condition(cases, conditions) {
let case_, found, names, split;

(names = [...(function* () { for (const [condition, _] of $iter(conditions.main)) { yield condition.name; } })()]);
if (($b.len(names) < 2)) {
return $b.tuple(cases);
}
(found = []);
for (case_ of $iter(cases)) {
(split = [...(function* () { for (const name of $iter(names)) { yield $replaced(case_, new Map([["name", ("" + $str(case_.name) + ", " + $str(name))], ["condition", name]])); } })()]);
(found = $add(found, ($truth(case_.condition) ? [case_] : split)));
}
return $b.tuple(found);
}
function file__train_from_document(document, file = "", folder = "", overrides = [], allow_paths = false) {
let belt, belt_record, cases, conditions, conveyor, criteria, division, drive, ends, error, known, laggings, own, parts, problem, pulleys, reader, record, records, report, told, train;

(document = overridden(document, overrides, file));
if ((!$in("train", document))) {
(drive = drive_file__drive_from_document(document, file, folder, undefined, allow_paths));
return Train.of(drive);
}
([record, report] = source__read_tables($c8e8b, document, file));
(belt_record = $m.get(record, "belt"));
(belt = ($truth($b.isinstance(belt_record, Record)) ? drive_build__build_belt(belt_record, report) : null));
(own = $m.get(record, "lagging"));
(laggings = new Laggings(($truth($b.isinstance(own, "dict")) ? own : $map([])), folder, allow_paths, report));
(records = [...(function* () { for (const item of $iter($or($m.get(record, "pulley"), () => []))) { if (!($truth($b.isinstance(item, Record)))) continue; yield item; } })()]);
(conditions = conditions__build_conditions(record, report));
(pulleys = [...(function* () { for (const item of $iter(records)) { yield drive_build__build_pulley(item, laggings, conditions, report); } })()]);
file___refuse_pulley_tensions(record, records, report);
tensions__report_uncertain_twice(record, report);
(criteria = drive_build__build_criteria(record, belt, report));
(conveyor = null);
if (($in("conveyor", document))) {
(conveyor = conveyed__build_train_conveyor(record, belt, $bound(criteria, "take_up"), report));
}
(train = $m.get(record, "train"));
(ends = ($truth($b.isinstance(train, Record)) ? [...(function* () { for (const key of $iter(["entry_tension", "exit_tension"])) { if (!(($in(key, train)))) continue; yield $at(train, key); } })()] : []));
drive_build__report_together(belt_record, belt, pulleys, ($truth(ends) ? $map([["train", $b.min(ends)]]) : $map([])), report);
report.raise_all();
(known = [belt, [...(function* () { for (const p of $iter(pulleys)) { yield p; } })()]]);
(reader = new Reader(record, ...$iter(known), report, $bound(criteria, "take_up")));
(parts = $map([...(function* () { for (const key of $iter(["title", "description", "creep_limit"])) { if (!(($in(key, record)))) continue; yield [key, $at(record, key)]; } })()]));
(cases = []);
if ((conveyor == null)) {
(cases = reader.cases());
} else {
(division = reader.division());
if ((division != null)) {
([conveyor, cases] = conveyed__conveyor_cases(conveyor, division, $at(record, "conveyor"), report));
(criteria = $replaced(criteria, new Map([["take_up", conveyed__train_take_up($bound(criteria, "take_up"), conveyor)]])));
}
}
report.raise_all();
try {
return $call(Train, [], [["belt", reader.belt], ["pulleys", reader.actual], ["cases", conditions__in_each_condition(cases, conditions)], ["criteria", criteria], ["nominal_diameters", ((!$eq(reader.actual, $b.tuple($bound(reader, "pulleys")))) ? reader.nominal : [])], ["read_from", new ReadFrom(document, folder, allow_paths)], ["conveyor", conveyor], ...parts]);
} catch ($error) {
if ($error instanceof InputError) {
error = $error;
(told = $map([]));
for (problem of $iter(error.problems)) {
$m.setdefault(told, [problem.message, problem.value], file___placed(problem, cases, file));
}
throw new InputError($m.values(told));
} else throw $error;
}
}
function file___refuse_pulley_tensions(record, pulleys, report) {
let case_, key, message, pulley, remedy;

(message = "the tensions of single pulleys follow from [train]");
for (pulley of $iter(pulleys)) {
for (key of $iter((function* () { for (const key of $iter($c6fe1)) { if (!(($in(key, pulley)))) continue; yield key; } })())) {
report.add([...$iter(pulley.place), key], message, "Leave it out.", $at(pulley.raw, key));
}
}
for (case_ of $iter($or($m.get(record, "load_case"), () => []))) {
if (($truth($b.isinstance(case_, Record)) && ($in("pulley", case_)))) {
(remedy = "Write a [load_case.train] table.");
report.add([...$iter(case_.place), "pulley"], message, remedy);
}
}
}
function conveyed__build_train_conveyor(record, belt, take_up, report) {
let key, message, remedy, train;

(train = $m.get(record, "train"));
if ($truth($b.isinstance(train, Record))) {
(message = "the [conveyor] table gives the tensions already");
for (key of $iter((function* () { for (const key of $iter($c2c8e)) { if (!(($in(key, train)))) continue; yield key; } })())) {
(remedy = "Leave it out, or the [conveyor] table.");
report.add([...$iter(train.place), key], message, remedy, $at(train.raw, key));
}
}
return conveyor_build__described_conveyor(record, belt, take_up, report);
}
function conveyed__conveyor_cases(conveyor, division, record, report) {
let cases, count, drives, every, given, message, remedy, shares, states;

(count = $b.len($bound(conveyor, "drives")));
(given = $b.isinstance(division, Shares));
(shares = ($truth($b.isinstance(division, Shares)) ? division.fractions : $mul([(1.0 / count)], count)));
(drives = $b.zip($bound(conveyor, "drives"), shares, $k({strict: true})));
(conveyor = $replaced(conveyor, new Map([["drives", $b.tuple((function* () { for (const [d, s] of $iter(drives)) { yield $replaced(d, new Map([["share", s]])); } })())]])));
if ((!$truth(given) && (conveyor.take_up_behind != null))) {
(message = ("" + "is between the drives, behind " + $str(conveyor.take_up_behind)));
(remedy = "List [[pulley]] from the take-up on, or write share in [train].");
report.add([...$iter(record.place), "take_up_distance"], message, remedy);
}
(states = $or(report.tried($bound(conveyor, "states"), $bound(record, "place"), $bound(record, "raw")), () => []));
(every = $b.zip(states, uncertain__uncertain_tensions(conveyor, states), $k({strict: true})));
(cases = report.tried((() => [...(function* () { for (const [s, of] of $iter(every)) { yield conveyed___train_case(s, division, of); } })()]), $bound(record, "place")));
return [conveyor, $or(cases, () => [])];
}
function conveyed___train_case(state, division, uncertainty) {
let drives, kind, runs;

(drives = state.drives);
(runs = $b.tuple((function* () { for (const i of $iter($b.range($sub($b.len(drives), 1)))) { yield $sub($at(drives, $add(i, 1)).entry, $at(drives, i).exit); } })()));
if ($truth($b.isinstance(division, Shares))) {
(division = new Shares($b.tuple((function* () { for (const drive of $iter(drives)) { yield drive.share; } })())));
}
(kind = state.kind);
return new TrainCase(state.name, state.entry, state.exit, division, runs, kind, undefined, undefined, uncertainty);
}
function conveyed__train_take_up(take_up, conveyor) {
let behind;

(behind = conveyor.take_up_behind);
return ((behind == null) ? take_up : $replaced(take_up, new Map([["after", behind]])));
}
function file___placed(problem, cases, file) {
let case_, own, prefix, rest;

for (case_ of $iter(cases)) {
(prefix = ("" + "load_case." + $str(case_.name) + "."));
if ($truth($m.startswith(problem.key, prefix))) {
(rest = $m.removeprefix(problem.key, prefix));
(own = (($eq(case_.name, "design")) ? [] : ["load_case", case_.name]));
return $replaced(problem, new Map([["key", ("" + $str(problems__place_text([...$iter(own), "train"])) + "." + $str(rest))], ["file", file]]));
}
}
return $replaced(problem, new Map([["file", file]]));
}
function source__syntax_problem(text, line, file = "") {
let lines, message, remedy, value, written;

(lines = $m.split(text, "\n"));
(written = ((0 < line && line <= $b.len(lines)) ? $m.strip($at(lines, $sub(line, 1))) : ""));
(message = "not valid TOML");
(remedy = "Text needs quotes, and so does a quantity: width = \"1200 mm\".");
if (!$truth($m.strip($m.join("", $slice(lines, $sub(line, 1), null))))) {
([message, remedy] = ["ends too early", "Close the bracket or the quotes that are left open."]);
} else {
if ($truth(source___stands_before(written, $slice(lines, null, $sub(line, 1))))) {
([message, remedy] = ["is there twice", "Leave one of them out."]);
} else {
if (($in("\\", written))) {
(remedy = "Write paths with / , or in single quotes: 'C:\\drives\\lagging.toml'.");
}
}
}
(value = ($truth(written) ? $shown(written) : ""));
return new Problem(message, remedy, file, undefined, value, line);
}
function source___stands_before(written, lines) {
let before, key, keys;

(key = $m.strip($at($m.partition(written, "="), 0)));
if ($truth($m.startswith(written, "["))) {
return ($in(written, [...(function* () { for (const before of $iter(lines)) { yield $m.strip(before); } })()]));
}
(keys = []);
for (before of $iter(lines)) {
(keys = ($truth($m.startswith(before, "[")) ? [] : [...$iter(keys), $m.strip($at($m.partition(before, "="), 0))]));
}
return $and((!$eq(key, "")), () => ($in(key, keys)));
}
function in_page_checks__arcs_of(drive) {

return [...(function* () { for (const case_ of $iter(drive.load_cases)) { for (const p of $iter(drive.pulleys)) { yield WrapArc.of(drive, p, case_); }} })()];
}
function in_page_checks__given_of(drive, arc) {
let of;

(of = arc.described());
return new in_page$Given(of.entry_tension, of.exit_tension, NaN, NaN, NaN, of.diameter, of.wrap_angle, of.overrun, of.recovery, of.width, drive.belt.modulus, in_page_checks___known($bound(drive.belt, "speed")), of.thickness, of.shear_modulus, of.compression_modulus, of.wear_coefficient, arc.creep_limit, arc.law.steepest_fall(), of.pitch_offset, arc.cover_compliance, in_page_checks___known($bound(drive.belt, "mass")), arc.slip_with_shear, of.belt_speed);
}
function in_page_checks___known(value) {
return ((value == null) ? NaN : value);
}
function in_page_checks__criteria_of(drive, arcs, index) {
let arc, case_, conditioned, pulley, rise;

(arc = $at(arcs, index));
([case_, pulley] = [drive.load_case($bound(arc, "load_case")), drive.pulley($bound(arc, "pulley"))]);
(conditioned = drive.in_case(case_));
(rise = gross_slip__rises(arcs, index, $bound(drive.criteria, "take_up")));
return new in_page$Criteria(drive.criteria.safety.of($bound(case_, "kind")), rise.tight, rise.slack, arc.cover_left_out, $mul(in_page_checks___known($bound(drive.belt, "breaking_strength")), arc.width), in_page_checks___known($bound(pulley, "mass")), of_wet__estimate_factor(new At(conditioned, case_, conditioned.pulley($bound(pulley, "name")))));
}
function gross_slip__rises(arcs, index, take_up) {
let after, names, pulls;

([pulls, names] = [[...(function* () { for (const arc of $iter(arcs)) { yield arc.effective_tension; } })()], [...(function* () { for (const arc of $iter(arcs)) { yield arc.pulley; } })()]]);
(after = take_up.place_among(names));
return new Rise(...$iter($b.map($b.float, pull__rise_among(pulls, index, $bound(take_up, "fixed"), after))));
}
function pull__rise_among(pulls, index, fixed, after) {
let ahead, behind, entry, leaving, lost, mine, total;

([total, mine] = [$b.sum(pulls), $at(pulls, index)]);
(ahead = $b.sum($slice(pulls, null, index)));
(behind = $b.sum($slice(pulls, $add(index, 1), null)));
(lost = ($truth(fixed) ? $mul(0.5, $b.abs(total)) : 0.0));
if ((!$truth(fixed) && (after >= 0))) {
(lost = ((total >= 0.0) ? $b.sum($slice(pulls, $add(after, 1), null)) : $neg($b.sum($slice(pulls, null, $add(after, 1))))));
}
(entry = $sub(((total >= 0.0) ? $add(mine, behind) : $neg(ahead)), lost));
(leaving = $sub(((total >= 0.0) ? behind : $sub($neg(ahead), mine)), lost));
return ((mine >= 0.0) ? [entry, leaving] : [leaving, entry]);
}
function of_wet__estimate_factor(of) {

if (($truth(of.drive.criteria.covered) || !$truth(of_wet__is_dry_only($bound(of, "drive"), $bound(of, "case"))))) {
return 0.0;
}
return of_wet__wet_factor($bound(of.pulley, "lagging"));
}
function of_wet__is_dry_only(drive, case_) {
let dry, laggings, named;

(laggings = (function* () { for (const p of $iter(drive.pulleys)) { for (const lag of $iter([p.lagging, ...$iter(p.conditions)])) { yield lag; }} })());
(named = [...(function* () { for (const c of $iter(drive.load_cases)) { if (!($truth(c.condition))) continue; yield c.condition; } })()]);
(dry = $and($b.all((function* () { for (const lag of $iter(laggings)) { yield ($eq(lag.condition, "dry")); } })()), () => $b.all((function* () { for (const name of $iter(named)) { yield ($eq(name, "dry")); } })())));
return $and(dry, () => $or(!$truth(case_.condition), () => ($eq($b.len(named), $b.len($bound(drive, "load_cases"))))));
}
function of_wet__wet_factor(lagging) {

try {
return $at(new Condition("wet").factor_of(lagging), 0);
} catch ($error) {
if ($error instanceof InputError) {
return NaN;
} else throw $error;
}
}
function in_page_checks__results_of(drive, arcs, found) {
let every;

(every = $b.tuple((function* () { for (const [arc, numbers] of $iter($b.zip(arcs, found, $k({strict: true})))) { yield in_page_checks__result_of(arc, numbers); } })()));
return new DriveResult(drive, every);
}
function in_page_checks__result_of(arc, found) {
let of;

(of = found.summary);
return new FoundArc(($truth($told($cc303, found, "solved")) ? "The pulley transmits its load." : "Gross slip: no creep gives enough friction for this tension ratio. Raise the slack-side tension (take-up), increase the wrap angle, or choose a lagging with more friction."), "distributed", arc, null, of.entry_tension, of.exit_tension, of.exit_creep, of.creep_shrinkage, of.creep_compression, of.creep_global, of.exit_slip, of.entry_creep_ratio, of.exit_creep_ratio, of.peak_shear_stress, of.peak_shear_angle, of.peak_shear_position, of.mean_friction, of.active_arc, of.outside_tested_share, of.stuck_arc, found.capacities, of, undefined, found);
}
function in_page_checks__train_drive(train, case_, pairs) {

return result__drive_with(train, [unsolved__load_case(train, case_, [...(function* () { for (const at of $iter(pairs)) { yield [at.entry, at.exit]; } })()])]);
}
function unsolved__load_case(train, case_, pairs) {
let names, tensions;

(names = [...(function* () { for (const p of $iter(train.pulleys)) { yield p.name; } })()]);
(tensions = $map([...(function* () { for (const [n, [a, b]] of $iter($b.zip(names, pairs, $k({strict: true})))) { yield [n, new Tensions(a, b)]; } })()]));
return new LoadCase(case_.name, tensions, case_.kind, case_.condition, case_.description, ($truth(case_.uncertainty) ? $map([["", case_.uncertainty]]) : $map([])));
}
function result__drive_with(train, cases) {

return new Drive(train.title, train.belt, train.pulleys, $b.tuple(cases), train.creep_limit, train.criteria, train.description);
}
function in_page_checks__running_at(arcs, speeds) {

return [...(function* () { for (const [arc, speed] of $iter($b.zip(arcs, speeds, $k({strict: true})))) { yield $replaced(arc, new Map([["belt_speed", ($truth($math.isnan(speed)) ? null : speed)]])); } })()];
}
function in_page_checks__alone(drive, name) {
let cases;

(cases = [...(function* () { for (const case_ of $iter(drive.load_cases)) { if (!(($eq(case_.name, name)))) continue; yield case_; } })()]);
return $replaced(drive, new Map([["load_cases", $b.tuple($slice([...$iter(cases), ...$iter(drive.load_cases)], null, 1))]]));
}
function in_page_checks__remarks_of(drive, verdict) {
let left;

(left = (function* () { for (const of of $iter(drive.laggings)) { if (!(($truth(of.fit) && $truth(of.fit.knots)))) continue; yield $m.format("The interval of the creep that the fit of {} leaves is not calculated in this page, but by wraparc solve.", [$bound(of, "name")], $map([])); } })());
return [...$iter(verdict.remarks), ...$iter($b.fromkeys(left))];
}
function in_page_checks__weak_kinds(drive) {
let _, found, grounds, pulley;

(found = []);
for (pulley of $iter(drive.pulleys)) {
([grounds, _] = of_data__law_words($bound(pulley, "lagging")));
(found = $add(found, [...$iter(grounds), ...$iter((function* () { for (const weak of $iter(of_data__weak_sources(drive, pulley))) { yield $at(weak, 0); } })())]));
}
return [...(function* () { for (const kind of $iter($c5dd1)) { if (!(($in(kind, found)))) continue; yield kind; } })()];
}
function of_data__law_words(lagging) {
let friction, law, untested, words;

([law, friction] = [$b.str($bound(lagging.source_of("law"), "kind")), ("" + "The friction of " + $str(lagging.name) + " is")]);
(words = (($in(law, $cf933)) ? [("" + $str(friction) + " " + $str($at($cf933, law)) + ".")] : []));
(untested = (lagging.law.tested == null));
(words = $add(words, ($truth(untested) ? [("" + $str(friction) + " without tests.")] : [])));
return [[law, ...$iter(($truth(untested) ? ["untested"] : []))], words];
}
function* of_data__weak_sources(drive, pulley) {
let belt, key, lagging, owner, owners, source, stated;

([lagging, belt] = [pulley.lagging, drive.belt]);
(owners = [[lagging.name, $map([...(function* () { for (const [k, v] of $iter($m.items(lagging.sources))) { if (!((!$eq(k, "law")))) continue; yield [k, v]; } })()])], ["belt", belt.sources], [("" + "pulley " + $str(pulley.name)), pulley.sources]]);
(stated = [...(function* () { for (const [owner, of] of $iter(owners)) { for (const [key, source] of $iter($m.items(of))) { yield [key, owner, source]; }} })()]);
if (((pulley.across != null) && (belt.in_plane_shear_stiffness == null))) {
yield ["estimated", "in_plane_shear_stiffness", "belt"];
}
if (($truth(pitch__covered(belt)) && (belt.cover_shear_modulus == null))) {
yield ["estimated", "cover_shear_modulus", "belt"];
}
for ([key, owner, source] of $iter([...$iter(stated), ["belt", "belt", belt.provenance]])) {
yield* $iter((function* () { for (const kind of $iter(of_data__weaknesses(source))) { yield [kind, key, owner]; } })());
}
}
function pitch__covered(belt) {
let found;

(found = pitch__layers_of(belt));
return $or((found.pulley_cover > 0.0), () => (found.carry_cover > 0.0));
}
function* of_data__weaknesses(source) {

if ($truth($m.startswith(source.note, "estimated"))) {
yield "estimated";
}
if (($in(source.kind, ["illustrative", "calibrated"]))) {
yield $b.str($bound(source, "kind"));
}
}
function in_page_checks__idle_in(drive) {

return $b.any((function* () { for (const arc of $iter(in_page_checks__arcs_of(drive))) { yield rule__idle(arc); } })());
}
function rule__idle(arc) {

return pull__idles($bound(arc, "entry_tension"), $bound(arc, "exit_tension"));
}
function judge__judge(result) {

if ((!$in(result, $c8123))) {
$put($c8123, result, new Verdict(judge___placed(judge__every_check(result), judge___conditions(result))));
}
return $at($c8123, result);
}
function judge__every_check(result) {

return $b.tuple(($truth($b.isinstance(result, TrainResult)) ? judge___train(result) : judge___drive(result)));
}
function* judge___train(result) {
let case_, check, checks, failing, opposing;
(checks = [...$iter(judge___of_members(result))]);
(failing = new Set((function* () { for (const check of $iter(checks)) { if (!((check.level === "FAILS"))) continue; yield check.place.load_case; } })()));
for (check of $iter(checks)) {
(opposing = $and(($eq(check.name, "opposing_drives")), () => check.missed));
if (($truth(opposing) && ($in(check.place.load_case, failing)))) {
(case_ = result.train.case($bound(check.place, "load_case")));
if ((check.value > $mul(0.1, $b.abs($bound(case_, "effective_tension"))))) {
yield $replaced(check, new Map([["level", "FAILS"]]));
continue;
}
}
yield check;
}
}
function* judge___of_members(result) {
let adrift, case_, check, why;
for (case_ of $iter(result)) {
yield* $iter(of_train__of_case($bound(result, "train"), case_));
if ($truth($b.isinstance(case_.case.division, Pulls))) {
yield* $iter(of_train__meetings(case_));
}
}
(adrift = new Set((function* () { for (const case_ of $iter(result)) { if (!($truth(case_.adrift))) continue; yield case_.case.name; } })()));
for (check of $iter(judge___drive(result.drive_result(), ...$iter(usual__owners_of($bound(result, "train")))))) {
if ((($eq(check.name, "gross_slip")) && ($in(check.place.load_case, adrift)))) {
(why = "load not divided");
yield rule__not_checked($bound(check, "name"), "Gross-slip safety", "gross-slip safety", $bound(check, "place"), undefined, why);
} else {
yield check;
}
}
}
function* of_train__of_case(train, case_) {
let at, beyond, driven, driven_by, helps, lost, motors, overrun, place, several;

(place = new Place("", $bound(case_.case, "name")));
if (($truth(case_.adrift) || ($in(case_.status, ["No operating point: a motor would have to work outside its curve. Change its set speed or gear, or choose another motor.", "The solver did not reach its accuracy on this train. Please report the drive file; until then change a value slightly."])))) {
(overrun = $b.any((function* () { for (const [m, motor] of $iter($b.zip($bound(case_, "members"), of_train___motors($bound(case_, "case")), $k({strict: false})))) { if (!($truth($b.isinstance(motor, Motor)))) continue; yield $and((m.motor != null), () => $and((m.motor.motor_load < 0.0), () => !$truth(motor.brakes))); } })()));
(beyond = of_train___beyond(case_));
(at = ((beyond == null) ? place : $replaced(place, new Map([["pulley", beyond.name]]))));
yield of_train__operating_point($bound(case_, "status"), $bound(case_, "reason"), at, overrun, beyond);
}
(several = ($b.len($bound(case_, "members")) > 1));
if (!$truth($told($cc303, case_.status, "solved"))) {
yield* $iter(($truth(several) ? of_train__not_working(place) : []));
return null;
}
if ($truth(several)) {
(lost = numbers__pull_against([...(function* () { for (const m of $iter(case_.members)) { yield m.arc.effective_tension; } })()]));
yield of_train__check_opposing_drives(lost, place, $bound(case_.case, "division"));
(driven = [...(function* () { for (const [p, m] of $iter($b.zip($bound(train, "pulleys"), $bound(case_, "members"), $k({strict: true})))) { if (!(!$truth(rule__idle($bound(m.arc, "arc"))))) continue; yield p; } })()]);
yield* $iter(of_drive__unknown_trims($bound(train, "belt"), driven, place));
}
yield of_train__train_balance($b.max($bound(case_, "tension_error"), $bound(case_, "speed_error")), place);
(motors = of_train___motors($bound(case_, "case")));
(driven_by = [...$iter($b.zip($bound(case_, "members"), motors, $k({strict: false})))]);
(helps = !$truth($b.all((function* () { for (const [m, motor] of $iter(driven_by)) { yield of_train___motor(m, motor, $bound(case_, "case"), true).missed; } })())));
yield* $iter((function* () { for (const [m, motor] of $iter(driven_by)) { yield of_train___motor(m, motor, $bound(case_, "case"), helps); } })());
}
function of_train___motors(case_) {
return ($truth($b.isinstance(case_.division, Motors)) ? case_.division.motors : []);
}
function of_train___beyond(case_) {
let end, high, low, member, motor, point, turns;

if ((case_.status !== "No operating point: a motor would have to work outside its curve. Change its set speed or gear, or choose another motor.")) {
return null;
}
for ([member, motor] of $iter($b.zip($bound(case_, "members"), of_train___motors($bound(case_, "case")), $k({strict: false})))) {
([point, turns] = [member.motor, member.rotation_speed]);
if ((!$truth($b.isinstance(motor, Motor)) || (point == null))) {
continue;
}
if ($truth(turning__beyond_motor($bound(member, "name"), turns, motor, point))) {
([low, high] = motor.limits());
(end = ((point.motor_load > 0.0) ? high : $neg(low)));
return new Beyond($bound(member, "name"), $b.abs($bound(point, "motor_load")), end);
}
}
return null;
}
function turning__beyond_motor(name, rotation, motor, point) {
let end, high, low, means, rounding, top, turns;

([low, high] = motor.limits());
(rounding = 1e-09);
if ((point.motor_load < $sub(low, rounding))) {
(end = (low / ((low >= 0.0) ? motor.gear_efficiency : (1.0 / motor.gear_efficiency))));
([turns, top] = turning___apart(rotation, motor.drum_speed($mul(end, motor.drum_torque))));
(means = (($eq(low, 0.0)) ? "it cannot brake" : ("" + "it brakes with " + $format($neg(low), ("" + ".3g")) + " rated torques")));
if (($eq(turns, top))) {
return ("" + "The belt drives pulley " + $str(name) + " at " + $str(turns) + ", where its motor ends: " + $str(means) + ".");
}
return ("" + "The belt drives pulley " + $str(name) + " at " + $str(turns) + ", faster than its motor allows: " + $str(top) + " at most, where " + $str(means) + ".");
}
if ((point.motor_load > $add(high, rounding))) {
(turns = display__display(rotation, "rotation_speed", "si", 4));
return ("" + "The motor of " + $str(name) + " needs " + $format(point.motor_load, ("" + ".3g")) + " times its rated torque, its curve ends at " + $format(high, ("" + ".3g")) + "; its pulley turns at " + $str(turns) + ".");
}
return "";
}
function turning___apart(one, other) {
let digits, told;

for (digits of $iter([4, 5, 6, 4])) {
(told = $b.tuple((function* () { for (const of of $iter([one, other])) { yield display__display(of, "rotation_speed", "si", digits); } })()));
if ((!$eq($at(told, 0), $at(told, 1)))) {
break;
}
}
return [$at(told, 0), $at(told, 1)];
}
function of_train__operating_point(status, reason, place, overrun = false, beyond = null) {
let action, end, fault, headline, label, load;

(fault = (status === "The solver did not reach its accuracy on this train. Please report the drive file; until then change a value slightly."));
([headline, label, action] = $at($c3340, status));
(load = NaN); (end = load);
if (((beyond != null) && !$truth(overrun))) {
(headline = "Motor torque {value} exceeds {limit}, the end of its curve");
([load, end] = [beyond.load, beyond.end]);
}
return new Check("operating_point", "Operating point", ($truth(fault) ? "INTERNAL ERROR" : "FAILS"), place, undefined, undefined, "operating point", load, end, undefined, true, undefined, ($truth(overrun) ? "The belt drives the motors: no operating point" : headline), ($truth(overrun) ? "Set brakes = true if the drive can brake." : action), check__escaped(reason), label);
}
function check__escaped(text) {

return $m.replace($m.replace(text, "{", "{{"), "}", "}}");
}
function* of_train__not_working(place) {
let name, noun, title;

for ([name, title, noun] of $iter([["opposing_drives", "Opposing drives", "opposing drives"], ["train_balance", "Balance of drives", "balance of drives"]])) {
yield rule__not_checked(name, title, noun, place, undefined, "no operating point");
}
}
function rule__not_checked(name, title, noun, place, missing = "", why = "") {

return new Check(name, title, "NOT CHECKED", place, undefined, undefined, noun, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, missing, why);
}
function numbers__pull_against(pulls) {
let small;

(small = $mul(0.001, $b.max((function* () { for (const pull of $iter(pulls)) { yield $b.abs(pull); } })())));
if (!(($b.min(pulls) < $neg(small)) && ($b.max(pulls) > small))) {
return 0.0;
}
return $b.min($b.sum((function* () { for (const p of $iter(pulls)) { yield $b.max(p, 0.0); } })()), $b.sum((function* () { for (const p of $iter(pulls)) { yield $b.max($neg(p), 0.0); } })()));
}
function of_train__check_opposing_drives(opposing, place, division) {
let action, opposes;

(opposes = (opposing > 0.0));
(action = "Try torque sharing or closer speeds: run wraparc trim.");
if ($truth($b.isinstance(division, Shares))) {
(action = "Set every load share above 0 %.");
} else {
if ($truth($b.isinstance(division, Pulls))) {
(action = "Give tensions with which every pulley drives.");
}
}
return new Check("opposing_drives", "Opposing drives", ($truth(opposes) ? "ATTENTION" : "OK"), place, undefined, "opposing_tension", "opposing drives", ($truth(opposes) ? opposing : NaN), undefined, "force", undefined, undefined, ($truth(opposes) ? "Drives oppose each other by {value}" : ""), ($truth(opposes) ? action : ""), undefined, ($truth(opposes) ? "drives oppose" : ""));
}
function* of_drive__unknown_trims(belt, pulleys, at) {
let first, opposite, place, pulley, shift;

for (pulley of $iter($slice(pulleys, 1, null))) {
(first = $at(pulleys, 0));
(shift = of_drive__open_shift(belt, first, pulley));
if ((shift > 0.0)) {
([place, opposite] = [$replaced(at, new Map([["pulley", pulley.name]])), (!$eq(pulley.side, first.side))]);
yield of_drive__unknown_trim($bound(first, "name"), shift, opposite, place);
}
}
}
function of_drive__open_shift(belt, first, other) {
let shift;

if ($truth($b.all((function* () { for (const pulley of $iter([first, other])) { yield (pitch__pitch_offset(belt, $bound(pulley, "side")) != null); } })()))) {
return 0.0;
}
(shift = numbers__trim_shift($bound(first, "diameter"), $bound(other, "diameter"), (!$eq(first.side, other.side))));
return ((shift > 0.0001) ? shift : 0.0);
}
function numbers__trim_shift(first, other, opposite) {

if ($truth(opposite)) {
return (0.004 / $mul(0.5, $b.min(first, other)));
}
return $b.abs($sub((0.005 / $mul(0.5, first)), (0.005 / $mul(0.5, other))));
}
function of_drive__unknown_trim(first, shift, opposite, place) {
let why;

(first = check__escaped(first));
if ($truth(opposite)) {
(why = ("" + "The belt turns its other side to " + $str(first) + ": covers that differ by {apart} were assumed."));
} else {
(why = ("" + "{layer} of belt assumed: pulleys of two diameters, compared with " + $str(first) + "."));
}
return new Check("belt_thickness", "Trim, belt thickness", "ATTENTION", place, undefined, undefined, "trim", undefined, undefined, undefined, undefined, undefined, "Speed trim uncertain by {shift} %: belt thickness missing", ("" + $str("Give pulley_cover, carry_cover and carcass") + "."), why, "trim without belt thickness", undefined, undefined, undefined, $map([["shift", new Amount($mul(100.0, shift), "number")], [($truth(opposite) ? "apart" : "layer"), new Amount(($truth(opposite) ? 0.004 : 0.01), "length")]]), false);
}
function of_train__train_balance(error, place) {
let text;

(text = new CheckText("Balance of drives", "drive balance error", "Drive balance error {value} exceeds {limit}", undefined, "Do not use this result. Report the drive file.", undefined, "internal error", "tolerance of the program"));
return $cb138.compare(error, 1e-05, place, text);
}
function of_train___motor(member, motor, case_, helps) {
let at, load, momentary, most;

([at, momentary] = [new Place($bound(member, "name"), $bound(case_, "name")), (!$eq(case_.kind, "running"))]);
if (((member.motor == null) || !$truth($b.isinstance(motor, Motor)))) {
return of_train__unrated(momentary, at);
}
([load, most] = [member.motor.motor_load, motor.bears(momentary)]);
return of_train__motor_load(load, most, momentary, at, helps, $bound(motor, "rated_power"));
}
function of_train__unrated(momentary, place) {
let name, title;

(name = ($truth(momentary) ? "momentary_load" : "motor_load"));
(title = $at($c625f, momentary));
return rule__not_checked(name, title, "motor torque", place, undefined, "a follower has no motor rating");
}
function of_train__motor_load(load, most, momentary, place, helps, power) {
let action, more, text;

(more = "motors of {times} times this torque");
(action = ($truth(momentary) ? ("" + "Try a slower start, or " + $str(more) + ".") : ("" + "Use " + $str(more) + ".")));
if (($truth(helps) && !$truth(momentary))) {
(action = ("" + "Try torque sharing, or " + $str(more) + "."));
}
if ($truth($math.isfinite(power))) {
(action = "Use motors of {power} or more (now {rated}).");
}
(text = new CheckText($at($c625f, momentary), "motor torque", $add("Motor torque {value} exceeds the {limit} ", ($truth(momentary) ? "momentary limit" : "rating")), undefined, action, ($truth(momentary) ? "" : "Above 115 % no usual service factor covers it (NEMA MG 1-14.37)."), "motor torque", ($truth(momentary) ? "IEC 60034-1: 1.6 times the rated torque for 15 s; no stall at 90 % of the voltage (NEMA MG 1-12.44, condensed edition of 2011: torque falls with its square)" : "rating of the motor, continuous duty"), $map([["power", new Amount(($mul(power, $b.abs(load)) / most), "power", "up")], ["times", new Amount(($b.abs(load) / most), "number", "up")], ["rated", new Amount(power, "power")]])));
return ($truth(momentary) ? $c58a5 : $c0dbc).compare($b.abs(load), most, place, text);
}
function* of_train__meetings(case_) {
let ends, one, other, place;

for ([one, other] of $iter($b.pairwise((function* () { for (const m of $iter(case_.members)) { yield m.arc.arc; } })()))) {
(ends = [one.exit_tension, other.pulley, other.entry_tension]);
(place = new Place($bound(other, "pulley"), $bound(case_.case, "name")));
yield* $iter(of_drive__meeting($bound(one, "pulley"), ...$iter(ends), place));
}
}
function* of_drive__meeting(before, leaves, after, enters, place) {

if (($b.abs($sub(leaves, enters)) <= $mul(0.02, $b.max(leaves, enters)))) {
return null;
}
yield new Check("meeting", "Tension between pulleys", "ATTENTION", place, undefined, undefined, "tension between pulleys", undefined, undefined, undefined, undefined, undefined, ("" + "Belt leaves " + $str(check__escaped(before)) + " at {leaves} but enters " + $str(check__escaped(after)) + " at {enters}"), ("" + "Let " + $str(check__escaped(after)) + " enter at {leaves}, or give [train] a run of {rise}."), undefined, "tensions differ", undefined, undefined, undefined, $map([["leaves", new Amount(leaves, "force")], ["enters", new Amount(enters, "force")], ["rise", new Amount($sub(enters, leaves), "force")]]), false);
}
function* usual__owners_of(train) {
let division, kinds, motor, pulley, turns;

yield* $iter(usual___conveyor_owners($bound(train, "conveyor")));
(division = $at(train.cases, 0).division);
if (($truth($b.isinstance(division, Speeds)) && $truth(division.absolute))) {
for ([pulley, turns] of $iter($b.zip($bound(train, "pulleys"), $bound(division, "rotation_speeds"), $k({strict: true})))) {
yield new Owner(turns, $c576d, "", new Place($bound(pulley, "name")));
}
}
for ([pulley, motor] of $iter($b.zip($bound(train, "pulleys"), ($truth($b.isinstance(division, Motors)) ? division.motors : []), $k({strict: false})))) {
(kinds = ($truth($b.isinstance(motor, Motor)) ? $c87cd : ["TorqueFollower"]));
yield new Owner(motor, kinds, ("" + "of the motor of pulley " + $str(pulley.name)), new Place($bound(pulley, "name")));
}
}
function* usual___conveyor_owners(conveyor) {
let flight, local, point;

yield new Owner(conveyor, ["Conveyor"], "of the conveyor");
if ((conveyor == null)) {
return null;
}
for (flight of $iter(conveyor.flights)) {
yield new Owner(flight, ["Flight"], ("" + "of flight " + $str(flight.name)));
}
for (point of $iter(conveyor.loadings)) {
yield new Owner(point, ["LoadingPoint"], ("" + "of loading point " + $str(point.name)));
}
for (local of $iter(conveyor.locals)) {
yield new Owner(local, ["Local"], "of a resistance");
}
yield new Owner($bound(conveyor, "travel"), ["Travel"], "of the take-up travel");
yield new Owner($bound(conveyor, "cema"), ["Cema"], "of CEMA");
}
function* judge___drive(result, ...others) {
let arc, arcs, by_case, cases, drive, name, pulley;
(drive = result.drive);
(cases = $map([...(function* () { for (const case_ of $iter(drive.load_cases)) { yield [case_.name, case_]; } })()]));
(by_case = $map([]));
for (arc of $iter(result)) {
$m.append($m.setdefault(by_case, $bound(arc.arc, "load_case"), []), arc);
}
for ([name, arcs] of $iter($m.items(by_case))) {
yield* $iter(judge___case(drive.in_case($at(cases, name)), $at(cases, name), arcs));
}
if ($truth($b.any((function* () { for (const pulley of $iter(drive.pulleys)) { yield pulley.across; } })()))) {
yield* $iter(in_page_checks__across(result));
}
yield* $iter(of_drive__take_up(drive));
yield* $iter(case_kind__case_kinds(drive));
yield* $iter(judge__diameters(drive));
yield* $iter(usual__usual_sizes(drive, ...$iter(others)));
for (pulley of $iter(drive.pulleys)) {
yield of_data__data(drive, pulley);
}
yield* $iter(of_data__belt_mass(drive));
yield* $iter(of_drive__reserve(drive));
}
function* judge___case(drive, case_, arcs) {
let index, pulley, result, rule, spot;
for ([index, result] of $iter($b.enumerate(arcs))) {
(pulley = drive.pulley($bound(result.arc, "pulley")));
yield of_arc__grip(drive, case_, arcs, index);
(spot = rules__spot_of(drive, case_, pulley, result));
for (rule of $iter($cedd5)) {
yield* $iter(rule.checks(spot));
}
if (($truth($b.all((function* () { for (const arc of $iter(arcs)) { yield rule__idle($bound(arc, "arc")); } })())) || ((result.arc.side < 0.0) && !$truth(rule__idle($bound(result, "arc")))))) {
yield of_drive__sense(case_, pulley);
}
}
}
function of_arc__grip(drive, case_, arcs, index) {
let name, place, result;

(result = $at(arcs, index));
(name = "gross_slip");
(place = new Place($bound(result.arc, "pulley"), $bound(case_, "name")));
if ((result.status === "The solver did not reach its accuracy on this arc. Please report the drive file; until then change a value slightly.")) {
return new Check(name, "Gross-slip safety", "INTERNAL ERROR", place, undefined, undefined, "gross-slip safety", undefined, undefined, undefined, undefined, undefined, "No solution", "Do not use this result. Report the drive file.", check__escaped($b.str($bound(result, "status"))), "not solved");
}
if ($truth(rule__idle($bound(result, "arc")))) {
return new Check(name, "Gross-slip safety", "OK", place, undefined, undefined, "gross-slip safety", undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, "not driven");
}
return of_arc__of_sliding(drive, case_, result, in_page_checks__sliding(result));
}
function in_page_checks__sliding(result, _rise = null) {

return new Sliding($bound(result.found, "place"), $bound(result.found, "cause"));
}
function of_arc__of_sliding(drive, case_, result, found) {
let check, factor, gone, lagging, place, rule, safety, take_up, tested, text, value, why;

([safety, take_up] = [drive.criteria.safety, drive.criteria.take_up]);
([rule, factor, gone] = [$c84c4, safety.of($bound(case_, "kind")), !$truth($told($cc303, result.status, "solved"))]);
(place = new Place($bound(result.arc, "pulley"), $bound(case_, "name")));
if (($truth($math.isnan($bound(found, "place"))) && !$truth(gone))) {
(why = "gross slip not located");
return rule__not_checked($bound(rule, "name"), "Gross-slip safety", "gross-slip safety", place, undefined, why);
}
(tested = $and(($eq(found.cause, 1)), () => !$truth(gone)));
if ($truth(tested)) {
(rule = $replaced(rule, new Map([["fails_beyond", NaN]])));
}
(lagging = check__escaped($bound(drive.pulley($bound(result.arc, "pulley")).lagging, "name")));
(value = ($truth(gone) ? $b.min($bound(found, "place"), 0.999) : found.place));
(text = new CheckText("Gross-slip safety", "gross-slip safety", ($truth(tested) ? "Tested friction transmits {value} times Te, minimum {limit}" : "Gross-slip safety {value} is below the {limit} minimum"), "Gross slip: safety {safety} is below {one}", undefined, ("" + $str($m.replace($at($c48c7, found.cause), "⟦lagging⟧", lagging)) + " Safety factor " + $str(case_.kind) + ", " + $str(of_arc__constant_words(take_up)) + "."), ($truth(tested) ? "slip outside tests" : "gross slip"), ("" + "safety factor " + $str(case_.kind) + ": " + $str($or(safety.source, () => "default of wraparc"))), $map([["slides", new Amount(0.0635, "length")], ["safety", new Amount(value, "number")], ["one", new Amount(1.0, "number")]])));
(check = rule.compare(value, factor, place, text));
return ($truth(gone) ? $replaced(check, new Map([["level", "FAILS"], ["headline", "Gross slip: safety {safety} is below {one}"]])) : check);
}
function of_arc__constant_words(take_up) {
let where;

if ($truth(take_up.fixed)) {
return "T1 + T2 constant (fixed take-up)";
}
(where = ($truth(take_up.after) ? ("" + "tension behind pulley " + $str(take_up.after)) : "T2"));
return ("" + $str(check__escaped(where)) + " constant (gravity take-up)");
}
function rules__spot_of(drive, case_, pulley, result = null) {
let belt, driving, first, known, last, slack, tensions;

([tensions, belt] = [$at(case_.tensions, pulley.name), drive.belt]);
(known = $and((result != null), () => $told($cc303, result.status, "solved")));
([first, last] = [$at(drive.pulleys, 0), $at(drive.pulleys, $neg(1))]);
(driving = ($at(case_.tensions, first.name).entry >= $at(case_.tensions, last.name).exit));
(slack = ($truth(driving) ? last : first));
return new Spot(drive, case_, pulley, new Place($bound(pulley, "name"), $bound(case_, "name")), new State($b.max($bound(tensions, "entry"), $bound(tensions, "exit")), $b.min($bound(tensions, "entry"), $bound(tensions, "exit")), (($eq(pulley.name, slack.name)) ? drive.slack_end(case_) : NaN), belt.width, pulley.diameter, ((belt.breaking_strength == null) ? NaN : belt.breaking_strength), pitch__centrifugal_of(belt), drive.creep_limit_of(pulley), NaN, (((result != null) && $truth(known)) ? rules___found(result) : $map([]))), result, (((result == null) || $truth(known)) ? "" : of_arc__no_state(result)));
}
function rules___found(result) {
let course;

(course = $map([["largest_slip", in_page_checks__largest_slip], ["slip_speed", in_page_checks__slip_speed]]));
return $map([...(function* () { for (const name of $iter($cc89a)) { if (!(((!$eq(name, "slip_speed")) || (result.arc.law.tested != null)))) continue; yield [name, (($in(name, course)) ? $at(course, name)(result) : $b.abs($b.getattr(result, name)))]; } })()]);
}
function in_page_checks__largest_slip(result) {

return result.found.largest_slip;
}
function in_page_checks__slip_speed(result) {

return result.found.slip_speed;
}
function of_arc__no_state(result) {

return ((result.status === "The solver did not reach its accuracy on this arc. Please report the drive file; until then change a value slightly.") ? "not solved" : "gross slip");
}
function of_drive__sense(case_, pulley) {
let none, tensions, what;

(tensions = $at(case_.tensions, pulley.name));
(none = pull__idles($bound(tensions, "entry"), $bound(tensions, "exit")));
(what = ($truth(none) ? "transmits no tension" : "brakes"));
return new Check("sense", ("" + $str(pulley.name) + " " + $str(what)), "OK", new Place($bound(pulley, "name"), $bound(case_, "name")), undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, false);
}
function* in_page_checks__across(_result) {

yield* $iter([]);
}
function* of_drive__take_up(drive) {
let after, case_, first, fixed, high, kind, last, low, named, ordered, other, tensions, what;

(kind = drive.criteria.take_up.kind);
if ((!$truth(kind) || (drive.conveyor != null))) {
return null;
}
(fixed = drive.criteria.take_up.fixed);
(tensions = $map([]));
for (case_ of $iter(drive.load_cases)) {
([first, last] = (function* () { for (const p of $iter([$at(drive.pulleys, 0), $at(drive.pulleys, $neg(1))])) { yield $at(case_.tensions, p.name); } })());
$put(tensions, case_.name, ($truth(fixed) ? $add(first.entry, last.exit) : drive.take_up_tension(case_)));
}
(ordered = alike__falling(tensions, ((name) => $at(tensions, name))));
([high, low] = [$at(ordered, 0), $at(ordered, $neg(1))]);
if ($truth(numbers__has_equal_tension($at(tensions, low), $at(tensions, high)))) {
return null;
}
(after = drive.criteria.take_up.after);
(what = ($truth(after) ? ("" + "tension behind " + $str(check__escaped(after))) : "T2"));
(what = ($truth(fixed) ? "T1 + T2" : what));
(other = (($truth(fixed) || $truth(after)) ? "" : of_drive___steady(drive)));
(named = [...(function* () { for (const name of $iter([low, high])) { yield new Place(undefined, name); } })()]);
yield new Check("take_up", "Take-up tension", "ATTENTION", undefined, undefined, undefined, "take-up tension", undefined, undefined, undefined, undefined, undefined, ("" + $str($m.capitalize(kind)) + " take-up needs equal " + $str(what) + ": " + $str(check__escaped($b.str($at(named, 0)))) + " has {least}, " + $str(check__escaped($b.str($at(named, 1)))) + " has {most}"), ("" + "Set the same " + $str(what) + " in both, or correct take_up.kind or take_up.after."), ($truth(other) ? ("" + "Behind " + $str(check__escaped(other)) + " the tension is equal in every load case.") : ""), "take-up tension", ("" + "take-up " + $str(kind) + ", input"), undefined, undefined, $map([["least", new Amount($at(tensions, low), "force")], ["most", new Amount($at(tensions, high), "force")]]), false);
}
function alike__falling(items, key) {
let every, numbers, rounded, step;

(every = $b.list(items));
(numbers = [...(function* () { for (const item of $iter(every)) { yield key(item); } })()]);
(step = $mul(1e-09, $b.max((function* () { for (const n of $iter(numbers)) { if (!(($b.abs(n) < Infinity))) continue; yield $b.abs(n); } })(), $k({default: 0.0}))));
(rounded = [...(function* () { for (const n of $iter(numbers)) { yield (($truth(step) && ($b.abs(n) < Infinity)) ? $b.round((n / step)) : n); } })()]);
return [...(function* () { for (const i of $iter($b.sorted($b.range($b.len(every)), $k({key: ((i) => $neg($at(rounded, i)))})))) { yield $at(every, i); } })()];
}
function numbers__has_equal_tension(least, most) {

return ($sub(most, least) <= $mul(0.1, most));
}
function of_drive___steady(drive) {
let behind, pulley;

for (pulley of $iter(drive.pulleys)) {
(behind = [...(function* () { for (const case_ of $iter(drive.load_cases)) { yield $at(case_.tensions, pulley.name).exit; } })()]);
if ($truth(numbers__has_equal_tension($b.min(behind), $b.max(behind)))) {
return pulley.name;
}
}
return "";
}
function* case_kind__case_kinds(drive) {
let case_, kind, place;

for (case_ of $iter(drive.load_cases)) {
(kind = case_kind__named_kind(case_));
if (!$truth(kind)) {
continue;
}
(place = new Place(undefined, case_.name));
yield new Check("case_kind", "Kind of load case", "ATTENTION", place, false, undefined, "kind of load case", undefined, undefined, undefined, undefined, undefined, ("" + "Load case " + $str(check__escaped($b.str(place))) + " is judged as running"), ("" + "Set kind = \"" + $str(kind) + "\" in load case " + $str(check__escaped($b.str(place))) + "."), ("" + "Its name says " + $str(kind) + ": safety factors and belt ratings of running are compared."), "kind of load case", "name and kind of the load case, as given", undefined, undefined, undefined, false);
}
}
function case_kind__named_kind(case_) {
let kinds;

(kinds = (($eq(case_.kind, "running")) ? case_names__named_kinds($bound(case_, "name")) : []));
return ($truth(kinds) ? $at(kinds, 0) : "");
}
function case_names__named_kinds(name) {
let plain, words;

(plain = $m.translate($m.lower(name), $cae1d));
(plain = $m.join(" ", $m.split($m.join("", [...(function* () { for (const c of $iter(plain)) { yield (($in(c, "abcdefghijklmnopqrstuvwxyz")) ? c : " "); } })()]))));
(words = $m.split($m.replace($m.replace(plain, "not aus", "notaus"), "not halt", "nothalt")));
if ($truth($b.any((function* () { for (const word of $iter(words)) { yield ($in(word, $c3b1b)); } })()))) {
return [];
}
return [...(function* () { for (const [kind, says] of $iter($m.items($c29fa))) { if (!($truth($b.any((function* () { for (const word of $iter(words)) { yield ($in(word, says)); } })())))) continue; yield kind; } })()];
}
function* judge__diameters(drive) {
let pulley, spot;

for (pulley of $iter(drive.pulleys)) {
(spot = rules__spot_of(drive, $at(drive.load_cases, 0), pulley));
yield* $iter($ca865.checks($replaced(spot, new Map([["place", new Place($bound(pulley, "name"))]]))));
}
}
function* usual__usual_sizes(drive, ...others) {
let odd, parts;

(parts = [...$iter(usual___others(drive, others))]);
(odd = $map([...(function* () { for (const check of $iter([...$iter(usual__unusual_sizes(drive, $b.bool(parts))), ...$iter(parts)])) { yield [check.text, check]; } })()]));
yield* $iter($m.values(odd));
if (!$truth(odd)) {
yield new Check("usual_sizes", "Input plausibility", "OK", undefined, undefined, undefined, "inputs", undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, false);
}
}
function* usual___others(drive, others) {
let ends, fabric, lagging, owner, place, pulley, rating, solid, stiff, width;
for (owner of $iter([...$iter(usual___owners(drive)), ...$iter(others)])) {
yield* $iter(usual___of_owner(owner));
if (($in(owner.kinds, [$c87cd, $c576d]))) {
yield* $iter(usual___turning(drive, owner));
}
}
yield* $iter(usual___motor_sizes(drive, [...(function* () { for (const o of $iter(others)) { if (!(($eq(o.kinds, $c87cd)))) continue; yield o.of; } })()]));
if ((drive.conveyor != null)) {
yield* $iter(usual___conveyor_sizes($bound(drive, "conveyor"), $bound(drive.belt, "width")));
}
(width = drive.belt.width);
for (pulley of $iter(drive.pulleys)) {
if ((pulley.mass != null)) {
(solid = $mul($mul($mul($mul(7850.0, 0.25), 3.141592653589793), $pow(pulley.diameter, 2)), width));
(ends = [$mul(0.02, solid), $mul(1.5, solid)]);
if (!$truth(numbers__usual($bound(pulley, "mass"), ...$iter(ends)))) {
(place = new Place($bound(pulley, "name")));
yield usual__unusual("pulley mass", "mass", place, $bound(pulley, "mass"), ends);
}
}
}
([rating, stiff] = [drive.belt.rating, drive.belt.modulus]);
(fabric = $and(($eq(drive.belt.kind, "fabric")), () => $and(rating, () => numbers__usual(rating, ...$iter($at($c39c4, 11))))));
if (($truth(fabric) && $truth(rating) && !$truth(numbers__usual((stiff / rating), 0.0, 250.0)))) {
yield usual__unusual("belt modulus over rating", "number", $cb829, (stiff / rating), [15.0, 250.0]);
}
for (lagging of $iter(drive.laggings)) {
yield* $iter(usual___law_sizes(lagging));
}
}
function* usual___owners(drive) {
let criteria, factor, lagging, name, of, place, pulley;

(criteria = drive.criteria);
yield new Owner($bound(drive, "belt"), ["Belt"], "of the belt");
yield new Owner($bound(criteria, "take_up"), ["TakeUp"], "of the take-up");
yield new Owner($bound(criteria, "standard"), ["DesignStandard"], "of the design standard");
yield new Owner($bound(criteria, "safety"), ["SafetyFactors"], "safety factor");
yield new Owner($bound(criteria, "sag"), ["Sag"], "for the sag of the belt");
yield* $iter(usual___conveyor_owners($bound(drive, "conveyor")));
for (lagging of $iter(drive.laggings)) {
(of = ("" + "of " + $str(lagging.name)));
yield new Owner(lagging, ["Lagging"], of);
yield new Owner($bound(lagging, "block"), ["Block"], ("" + "of the blocks " + $str(of)));
yield new Owner($bound(lagging, "cost"), ["Cost"], ("" + "that the cost " + $str(of) + " is for"));
for ([name, factor] of $iter($m.items(lagging.condition_factors))) {
yield new Owner(factor, ["ConditionFactor"], ("" + "on the friction " + $str(of) + ", " + $str(name)));
}
}
for (pulley of $iter(drive.pulleys)) {
([place, of] = [new Place($bound(pulley, "name")), ("" + "of pulley " + $str(pulley.name))]);
if ((pulley.across != null)) {
yield new Owner($bound(pulley, "across"), ["Across"], of, place);
yield new Owner($bound(pulley.across, "before"), $c35d3, ("" + "before pulley " + $str(pulley.name)), place);
yield new Owner($bound(pulley.across, "after"), $c35d3, ("" + "behind pulley " + $str(pulley.name)), place);
}
}
}
function* usual___of_owner(owner) {
let check, ends, happening, headline, heights, key, limit, limits, most, name, of, profile, tables, value;

([of, limits] = [owner.of, $or($b.getattr($bound(owner, "of"), "LIMITS", null), () => $map([]))]);
(tables = [...$iter(owner.more), ...$iter((function* () { for (const kind of $iter(owner.kinds)) { yield $m.get($ce207, kind, $map([])); } })())]);
for ([key, limit] of $iter($m.items(limits))) {
([ends, value] = [$b.next((function* () { for (const t of $iter(tables)) { if (!(($in(key, t)))) continue; yield $at(t, key); } })(), null), $b.getattr(of, key)]);
if (($truth(ends) && $truth(value) && !$truth(numbers__usual(value, ...$iter(ends))))) {
(name = $m.rstrip(("" + $str($m.replace(key, "_", " ")) + " " + $str(owner.words))));
yield usual__unusual(name, $bound(limit, "dimension"), $bound(owner, "place"), value, ends);
}
}
for (happening of $iter($or($b.getattr(of, "happenings", null), () => []))) {
if ((happening.at >= of.duration)) {
(check = usual__unusual("start", "time", $cb829, $bound(happening, "at"), [0.0, of.duration]));
(headline = ("" + "Event " + $str(check__escaped($bound(of, "name"))) + " starts at {value}, after the end {limit}"));
yield $replaced(check, new Map([["headline", headline], ["action", "Give an earlier time."]]));
}
}
if (($in("Across", owner.kinds))) {
for ([key, most] of $iter($m.items($cc9d1))) {
(profile = $b.getattr(of, key));
(heights = ((profile == null) ? [] : [profile.largest, $neg($b.min([...$iter(profile.value), 0.0]))]));
if (($b.max(heights, $k({default: 0.0})) > most)) {
(name = $m.rstrip(("" + $str($m.replace(key, "_", " ")) + " " + $str(owner.words))));
yield usual__unusual(name, "length", $bound(owner, "place"), $b.max(heights), [0.0, most]);
}
}
}
}
function numbers__usual(value, least, most) {

return !((value < least) || ((value > most) && $truth($math.isfinite(value))));
}
function usual__unusual(name, dimension, place, value, ends) {
let action, headline, least, meant, most, near, small, usual_ends;

([least, most] = ends);
(small = ((least > 0.0) ? least : $mul(0.1, most)));
(meant = $m.join(" or ", parse__meant_by(value, dimension, small, most)));
(action = ("" + "Check the unit of " + $str(name) + $str(($truth(meant) ? ("" + ": " + $str(meant) + "?") : "."))));
if (($eq(dimension, "number"))) {
(near = $b.next((function* () { for (const n of $iter([0.1, 10.0, 0.01, 100.0])) { if (!((least <= $mul(n, value) && $mul(n, value) <= most))) continue; yield n; } })(), null));
(action = ("" + "Check " + $str(name) + $str(((near == null) ? "." : ("" + ": " + $format($mul(near, value), ("" + ".3g")) + "?")))));
}
if ((($eq(name, "wrap")) && (value > most))) {
(action = "Give each pulley its own wrap.");
}
if (($in(name, $ca493))) {
(action = ("" + "Check " + $str($at($ca493, name)) + "."));
}
(usual_ends = cellOf(most, dimension, undefined, "to", least));
(headline = ("" + $str($m.upper($slice(name, null, 1))) + $str($slice(name, 1, null)) + " {value} is outside the usual " + $str(usual_ends)));
if ((($eq(name, "wrap")) && (value > most))) {
(headline = "Wrap {value} exceeds {limit} on one pulley");
}
return new Check("usual_sizes", "Input plausibility", "ATTENTION", place, undefined, undefined, name, value, ((value > most) ? most : least), dimension, undefined, (value > most), headline, check__escaped(action), undefined, "implausible input", "sizes that conveyor drives have", undefined, undefined, undefined, false);
}
function parse__meant_by(value, dimension, least, most) {
let found, means, number, seldom, short, text, texts, unit, units, written;

(found = []);
(units = $m.get($c5787, dimension, []));
for (written of $iter(units)) {
(number = (value / parse__unit_factor(written, dimension)));
(short = $b.float(("" + $format(number, ("" + ".3g")))));
if (($b.abs($sub(number, short)) > $mul(1e-09, $b.abs(short)))) {
continue;
}
for (unit of $iter(units)) {
(means = $mul(short, parse__unit_factor(unit, dimension)));
if (((least <= means && means <= most) && (!$eq(unit, written)))) {
(seldom = $add($mul(2, ($in(unit, ["cm", "ft"]))), !(1.0 <= short && short < 1000.0)));
$m.append(found, [seldom, means, ("" + $format(short, ("" + "g")) + " " + $str(unit))]);
}
}
}
(texts = $b.dict());
found.splice(0, Infinity, ...$b.sorted(found, $k({key: ((one) => $at(one, 0))})));
for ([seldom, means, text] of $iter(found)) {
if (((seldom < 3) || !$truth(texts))) {
$m.setdefault(texts, ("" + $format(means, ("" + ".9g"))), text);
}
}
return $slice($b.list($m.values(texts)), null, 2);
}
function* usual___turning(drive, owner) {
let action, belt, check, dimension, ends, motor, name, power, pulley, radius, setting, speed, turns, value, values;

([motor, pulley, power, speed] = [owner.of, drive.pulley($bound(owner.place, "pulley")), NaN, NaN]);
([turns, action] = [motor, "Check train.speeds, diameter, belt speed."]);
if ($truth($b.isinstance(motor, Motor))) {
([power, speed] = [motor.rated_power, motor.rated_speed]);
(setting = ($truth($b.isinstance(motor, VariableSpeed)) ? motor.setting : 1.0));
(turns = ($mul(setting, speed) / motor.gear_ratio));
(action = "Check gear_ratio, rated_speed, diameter, belt speed.");
}
(belt = ((drive.belt.speed == null) ? NaN : drive.belt.speed));
(radius = $add(pulley.radius, $or(pitch__pitch_offset($bound(drive, "belt"), $bound(pulley, "side")), () => 0.0)));
(values = numbers__compared_motor(power, speed, turns, radius, belt));
for ([[name, dimension], value, ends] of $iter($b.zip($c1429, values, $cbfa6, $k({strict: true})))) {
if (!$truth(numbers__usual(value, ...$iter(ends)))) {
(check = usual__unusual(name, dimension, $bound(owner, "place"), value, ends));
if (($eq(name, "pulley speed over belt speed"))) {
(check = $replaced(check, new Map([["headline", "Pulley speed {drum} does not match belt speed {belt}"], ["action", action], ["full", "The speed of the pulley was used."], ["more", $map([["drum", new Amount($mul(turns, radius), "speed")], ["belt", new Amount(belt, "speed")]])]])));
}
yield check;
}
}
}
function numbers__compared_motor(power, speed, drum, radius, belt) {

return [power, speed, ($mul(drum, radius) / belt)];
}
function* usual___motor_sizes(drive, motors) {
let needed, pulls, rated;

(pulls = [...(function* () { for (const case_ of $iter(drive.load_cases)) { yield $b.abs($sub($at(case_.tensions, $at(drive.pulleys, 0).name).entry, $at(case_.tensions, $at(drive.pulleys, $neg(1)).name).exit)); } })()]);
(needed = $mul($b.max(pulls), $or(drive.belt.speed, () => NaN)));
(rated = $b.sum((function* () { for (const motor of $iter(motors)) { yield $mul(motor.count, motor.rated_power); } })()));
if (($truth(rated) && $truth(needed) && !$truth(numbers__usual((rated / needed), 0.0, 6.0)))) {
yield usual__unusual("motor power over required power", "number", $cb829, (rated / needed), [0.0, 6.0]);
}
}
function* usual___conveyor_sizes(of, width) {
let dimension, ends, key, least, load, most, name, odd, slope, value;

(odd = false);
for ([value, [key, ...ends]] of $iter($b.zip(of.sizes(), $ce959, $k({strict: true})))) {
([least, most] = (function* () { for (const end of $iter(ends)) { yield $mul(end, (($in(key, $c660d)) ? width : 1.0)); } })());
if (!$truth(numbers__usual(value, least, most))) {
(odd = true);
(name = ("" + "conveyor " + $str($m.replace(key, "_", " "))));
(dimension = $at($cc312, key).dimension);
yield usual__unusual(name, dimension, $cb829, value, [least, most]);
}
}
([least, most] = (function* () { for (const end of $iter([0.7, 700.0])) { yield $b.float(("" + $format($mul(end, $pow(width, 2)), ("" + ".2g")))); } })());
([load, slope] = [[least, most], (of.lift / of.length)]);
if (!($truth(odd) || $truth(numbers__usual($bound(of, "material"), ...$iter(load))))) {
yield usual__unusual("material per length of belt", "mass_per_length", $cb829, $bound(of, "material"), load);
}
if (!($truth(odd) || $truth(numbers__usual(slope, $neg(0.5), 0.5)))) {
yield usual__unusual("conveyor lift over length", "number", $cb829, slope, [$neg(0.5), 0.5]);
}
}
function* usual___law_sizes(lagging) {
let dimension, ends, friction, key, law, name, odd, of, pressures, slip, tested, value;

([tested, of] = [lagging.law.tested, ("" + "lagging " + $str(lagging.name))]);
if ((!$eq(lagging.condition, "dry"))) {
(of = $add(of, ("" + ", " + $str(lagging.condition))));
}
(odd = false);
for ([key, [name, dimension, ends]] of $iter($m.items($cc189))) {
(value = $b.getattr(tested, key, null));
if (((value != null) && !$truth(numbers__usual(value, ...$iter(ends))))) {
(odd = true);
yield usual__unusual(("" + $str(name) + " of " + $str(of)), dimension, $cb829, value, ends);
}
}
if ($truth(odd)) {
return null;
}
([pressures, slip] = [[100000.0], 0.01]);
if ((tested != null)) {
([pressures, slip] = [[tested.pressure_min, tested.pressure_max], tested.slip_max]);
}
(law = lagging.law.compact());
for (friction of $iter([...(function* () { for (const pressure of $iter(pressures)) { yield summary__available(law, slip, pressure); } })()])) {
if (!$truth(numbers__usual(friction, ...$iter($cece7)))) {
yield usual__unusual(("" + "friction of " + $str(of)), "number", $cb829, friction, $cece7);
return null;
}
}
}
function* usual__unusual_sizes(drive, odd) {
let case_, dimension, least, made, most, name, names, place, pulley, size, value, values;

for (case_ of $iter(drive.load_cases)) {
for (pulley of $iter(drive.in_case(case_).pulleys)) {
(names = usual___names(pulley, case_));
(values = numbers__compared_sizes(usual__sizes_of(drive, case_, pulley)));
for ([[name, dimension, place], value, [least, most]] of $iter($b.zip(names, values, $c39c4, $k({strict: true})))) {
(made = $or(($in(name, ["belt modulus over rating", "belt strength over rating", "tension for sag"])), () => ($eq(name, "wrap pressure at the belt rating"))));
if (!($truth(numbers__usual(value, least, most)) || ($truth(made) && $truth(odd)))) {
(size = (($in(dimension, $c5944)) ? drive.belt.width : 1.0));
(odd = true);
yield usual__unusual(name, dimension, place, $mul(size, value), [$mul(size, least), $mul(size, most)]);
}
}
}
}
}
function usual___names(pulley, case_) {
let at, belt, drum;

([belt, drum, at] = [new Place(), new Place($bound(pulley, "name")), new Place($bound(pulley, "name"), $bound(case_, "name"))]);
return [["belt width", "length", belt], ["belt modulus", "force_per_width", belt], ["belt speed", "speed", belt], ["diameter", "length", drum], ["wrap", "angle", drum], ["wrap", "angle", drum], ["creep limit", "length", drum], ["overrun", "length", drum], ["lagging thickness", "length", drum], ["shear modulus", "pressure", drum], ["compression modulus", "pressure", drum], ["belt rating", "force_per_width", belt], ["bond strength", "pressure", drum], ["fatigue limit", "pressure", drum], ["maximum wrap pressure of the belt", "pressure", belt], ["minimum pulley diameter of the belt", "length", belt], ["tension for sag", "force", belt], ["belt strength over rating", "number", belt], ["belt modulus over rating", "number", belt], ["wrap pressure at the belt rating", "pressure", drum], ["entry tension", "force", at], ["exit tension", "force", at], ["power", "power", at], ["belt mass", "mass_per_length", belt]];
}
function usual__sizes_of(drive, case_, pulley) {
let belt, idle, lagging, sag, tensions;

([belt, lagging, sag] = [drive.belt, pulley.lagging, drive.criteria.sag]);
(tensions = $at(case_.tensions, pulley.name));
(idle = pull__idles($bound(tensions, "entry"), $bound(tensions, "exit")));
function known(value) {
return ((value == null) ? NaN : value);
}
$sig(known, ["value"], false);
return new Sizes(belt.width, belt.modulus, known($bound(belt, "speed")), pulley.diameter, ($truth(idle) ? pulley.wrap_angle : NaN), ($truth(idle) ? NaN : pulley.wrap_angle), drive.creep_limit_of(pulley), known($bound(pulley, "overrun")), lagging.thickness, lagging.shear_modulus, lagging.compression_modulus, known($bound(belt, "rating")), known($bound(belt, "breaking_strength")), known($bound(lagging, "bond_strength")), known($bound(lagging, "fatigue_limit")), known($bound(belt, "largest_wrap_pressure")), known($bound(belt, "least_pulley_diameter")), known(((sag == null) ? null : sag.tension)), tensions.entry, tensions.exit, (($truth(idle) || ($b.len($bound(drive, "pulleys")) > 1)) ? NaN : tensions.effective), known($bound(belt, "mass")));
}
function numbers__compared_sizes(of) {

return [of.width, of.modulus, of.speed, of.diameter, of.idle_wrap, of.wrap_angle, of.creep_limit, of.overrun, of.thickness, of.shear_modulus, of.compression_modulus, of.rating, of.bond_strength, of.fatigue_limit, of.face_pressure, of.least_diameter, (of.sag / of.width), (of.strength / of.rating), (of.modulus / of.rating), ($mul(2.0, of.rating) / of.diameter), (of.entry / of.width), (of.leaving / of.width), $mul($b.abs($bound(of, "pull")), of.speed), (of.mass / of.width)];
}
function of_data__data(drive, pulley) {
let grounds, key, kind, lagging, owned, owner, sentences, sources, weak, word;

(lagging = pulley.lagging);
(sources = $map([]));
(weak = []);
([grounds, sentences] = of_data__law_words(lagging));
(weak = $add(weak, [...(function* () { for (const kind of $iter(grounds)) { if (!(($in(kind, $cb216)))) continue; yield [kind, "friction", "friction"]; } })()]));
for ([kind, key, owner] of $iter(of_data__weak_sources(drive, pulley))) {
(word = of_data__key_word(key));
(owned = $and(($eq(owner, "belt")), () => $m.startswith(word, owner)));
$m.append($m.setdefault(sources, kind, []), ($truth(owned) ? word : ("" + $str(word) + " of " + $str(owner))));
$m.append(weak, [kind, key, word]);
}
(sentences = $add(sentences, [...(function* () { for (const kind of $iter($c5dd1)) { if (!(($in(kind, sources)))) continue; yield ("" + $str($m.capitalize(kind)) + ": " + $str($m.join(", ", $b.fromkeys($at(sources, kind)))) + "."); } })()]));
return new Check("data", "Data line", "OK", new Place($bound(pulley, "name")), undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, check__escaped($m.join(" ", sentences)), undefined, undefined, undefined, undefined, undefined, false, $b.tuple(weak));
}
function of_data__key_word(key) {

return $m.get($cd058, key, $m.replace(key, "_", " "));
}
function* of_data__belt_mass(drive) {
let belt, case_, least, most, place, pulley, slack, tensions;

(belt = drive.belt);
if (((belt.mass != null) || (belt.speed == null))) {
return null;
}
(tensions = [...(function* () { for (const case_ of $iter(drive.load_cases)) { for (const [name, of] of $iter($m.items(case_.tensions))) { yield [$b.min($bound(of, "entry"), $bound(of, "exit")), name, case_.name]; }} })()]);
([slack, pulley, case_] = $b.min(tensions, $k({key: ((of) => $at(of, 0))})));
([least, most] = (function* () { for (const mass of $iter(belt_mass__usual_mass(belt))) { yield pitch__centrifugal_force(mass, $bound(belt, "speed")); } })());
if ((most <= $mul(0.02, slack))) {
return null;
}
(place = new Place(pulley, case_));
yield new Check("belt_mass", "Belt m v2", "NOT CHECKED", place, undefined, undefined, "belt m v2", undefined, undefined, undefined, undefined, undefined, undefined, undefined, ("" + "Belt mass missing: m v2 {least} to {most} (estimated) is left out, up to {share} % of T2" + $str(check__escaped($bound(place, "bracket"))) + "."), undefined, "carcasses of the catalogue and usual covers", "belt.mass", undefined, $map([["least", new Amount(least, "force")], ["most", new Amount(most, "force")], ["share", new Amount(($mul(100.0, most) / slack), "number")]]), false);
}
function belt_mass__usual_mass(belt) {
let covers, heavy, known, least, light, most, near, row, rows;

(rows = [...(function* () { for (const row of $iter(belts())) { if (!(((row.carcass_mass != null) && (row.cover_mass != null)))) continue; yield row; } })()]);
for (near of $iter([[...(function* () { for (const row of $iter(rows)) { if (!(($eq(row.name, belt.name)))) continue; yield row; } })()], [...(function* () { for (const row of $iter(rows)) { if (!(($truth(belt_mass___kind_agrees(row, belt)) && $truth(belt_mass___rating_agrees(row, belt))))) continue; yield row; } })()], [...(function* () { for (const row of $iter(rows)) { if (!($truth(belt_mass___kind_agrees(row, belt)))) continue; yield row; } })()]])) {
if ($truth(near)) {
(rows = near);
break;
}
}
(known = pitch__layers_of(belt));
(covers = [...(function* () { for (const [cover, ends] of $iter($b.zip([known.pulley_cover, known.carry_cover], $c1f4f, $k({strict: true})))) { yield ($truth($math.isnan(cover)) ? ends : [cover, cover]); } })()]);
([least, most] = [Infinity, 0.0]);
for (row of $iter(rows)) {
(light = belt_mass__layer_mass(row, $bound(belt, "width"), $at($at(covers, 0), 0), $at($at(covers, 1), 0)));
(heavy = belt_mass__layer_mass(row, $bound(belt, "width"), $at($at(covers, 0), 1), $at($at(covers, 1), 1)));
([least, most] = [$b.min(least, $or(light, () => Infinity)), $b.max(most, $or(heavy, () => 0.0))]);
}
return new MassRange(least, most);
}
function belt_mass___kind_agrees(row, belt) {
return $or(($eq(row.kind, belt.kind)), () => !$truth(belt.kind));
}
function belt_mass___rating_agrees(row, belt) {
return $and((belt.rating != null), () => ($b.abs($math.log((row.rating / belt.rating))) <= $math.log(1.3)));
}
function* of_drive__reserve(drive) {
let noun, why;

if ($truth(drive.states_uncertainty)) {
([noun, why] = ["reserve", "wraparc solve checks stated uncertainties"]);
yield rule__not_checked("reserve", "Reserve", noun, new Place(), undefined, why);
}
}
function judge___conditions(result) {
let cases, conditions;

(cases = ($truth($b.isinstance(result, TrainResult)) ? result.train.cases : result.drive.load_cases));
(conditions = $map([...(function* () { for (const case_ of $iter(cases)) { yield [case_.name, case_.condition]; } })()]));
return (($b.len($b.set($m.values(conditions))) > 1) ? conditions : $map([]));
}
function judge___placed(checks, conditions) {

if (!$truth(conditions)) {
return checks;
}
return $b.tuple((function* () { for (const check of $iter(checks)) { yield (($in(check.place.load_case, conditions)) ? $replaced(check, new Map([["place", $replaced(check.place, new Map([["condition", $at(conditions, check.place.load_case)]]))]])) : check); } })());
}
function least_tension__least_tension(result) {
let one;

if (($truth($b.isinstance(result, TrainResult)) && $truth(result.adrift))) {
return null;
}
(one = ($truth($b.isinstance(result, TrainResult)) ? result.drive_result() : result));
if ((!$in(one, $cd36e))) {
$put($cd36e, one, least_tension__least_of(one, $bound(one, "drive")));
}
return $at($cd36e, one);
}
function least_tension__least_of(result, drive) {
let either, figure, found, given, held, weight, worst;

if ($truth($b.any((function* () { for (const a of $iter(result)) { yield $and(least_tension___pulls(a), () => $math.isnan($bound(a.capacities, "gross_slip_capacity"))); } })()))) {
return null;
}
(worst = $map([]));
for (figure of $iter(least_tension__figures(result, drive))) {
(held = $m.get(worst, $bound(figure, "name")));
(either = ((held == null) ? [figure] : [held, figure]));
$put(worst, figure.name, ($truth(figure.at_least) ? alike__largest : alike__least)(either, least_tension___tension));
}
if (!$truth($b.any((function* () { for (const f of $iter($m.values(worst))) { yield $and(f.at_least, () => f.binding); } })()))) {
return null;
}
(found = new LeastTension($b.tuple($m.values(worst)), 0.0, 0.0));
if ((drive.conveyor != null)) {
(given = drive.conveyor.take_up);
} else {
(given = drive.take_up_tension(drive.load_case($bound(found.governing.place, "load_case"))));
}
(weight = drive.criteria.take_up.counterweight($bound(found, "tension")));
return new LeastTension($bound(found, "figures"), given, weight, $b.bool($bound(drive, "take_up_place")));
}
function least_tension___pulls(result) {
return !$truth(rule__idle($bound(result, "arc")));
}
function* least_tension__figures(result, drive) {
let arcs, case_, end, name;

for ([name, arcs] of $iter($m.items(least_tension___by_case(result)))) {
(case_ = result.drive.load_case(name));
(end = drive.take_up_tension(case_));
yield* $iter(least_tension___figures(result.drive.in_case(case_), case_, arcs, end));
}
if ((drive.conveyor != null)) {
yield least_tension__taut($bound(drive, "conveyor"));
}
}
function least_tension___by_case(result) {
let arc, by_case;
(by_case = $map([]));
for (arc of $iter(result)) {
$m.append($m.setdefault(by_case, $bound(arc.arc, "load_case"), []), arc);
}
return by_case;
}
function* least_tension___figures(drive, case_, arcs, end) {
let index, least, offset, place, result, rule, spot;

for ([index, result] of $iter($b.enumerate(arcs))) {
(spot = rules__spot_of(drive, case_, drive.pulley($bound(result.arc, "pulley")), result));
([place, offset] = [spot.place, $sub(end, spot.state.slack)]);
if ($truth(least_tension___pulls(result))) {
(least = result.capacities.least_exit_tension);
yield new Figure("creep", "Creep", $add(offset, ($truth($math.isnan(least)) ? Infinity : least)), place);
yield* $iter(least_tension___slip(result, offset, place));
yield* $iter(least_tension___estimates(spot, result, offset));
yield* $iter(least_tension___standard(spot, offset));
yield least_tension___gross_slip(drive, case_, arcs, index, end);
}
for (rule of $iter($cedd5)) {
yield* $iter(least_tension___of_tension(rule, spot, end));
}
}
}
function* least_tension___slip(result, offset, place) {
let least, tested;

(tested = result.arc.law.tested);
if (((tested != null) && (tested.slip_max < result.arc.creep_limit))) {
(least = in_page_checks__least_with_slip(result, $bound(tested, "slip_max")));
yield new Figure("tested_slip", "Slip, tested range", $add(offset, least), place);
}
}
function in_page_checks__least_with_slip(result, _limit) {

return result.found.least_for_slip;
}
function* least_tension___estimates(spot, result, offset) {
let asks, factor, rule, title;

(factor = of_wet__estimate_factor(spot));
for ([rule, title, asks] of $iter([[$c8a85, "Creep with cover", in_page_checks__least_when_covered(result)], [$cef26, "Creep, 95 % bound", least_tension___by_interval(result)], [$c2e75, "Wet creep", in_page_checks__least_when_wet(result, factor)]])) {
if (!$truth($math.isnan(asks))) {
yield new Figure($bound(rule, "name"), title, $add(offset, asks), $bound(spot, "place"), false);
}
}
}
function in_page_checks__least_when_covered(result) {

return result.found.least_when_covered;
}
function least_tension___by_interval(result) {
if (($eq(result.method, "paper"))) {
return NaN;
}
return in_page_checks__least_by_interval($bound(result, "arc"), $bound(result.capacities, "least_exit_tension"));
}
function in_page_checks__least_by_interval(_arc, _least) {

return NaN;
}
function in_page_checks__least_when_wet(result, factor) {

return ((factor > 0.0) ? result.found.least_when_wet : NaN);
}
function* least_tension___standard(of, offset) {
let binding, criteria, pulley, rule, tension;
([criteria, pulley] = [of.drive.criteria, of.pulley]);
(rule = design_standard__find_requirement($bound(criteria, "standard"), $bound(criteria, "take_up"), $bound(pulley, "lagging"), $bound(pulley, "wrap_angle")));
if ((rule == null)) {
return null;
}
([binding, tension] = [criteria.standard.binding, Infinity]);
if (!$truth($math.isnan($bound(rule, "wrap_factor")))) {
(tension = $add(offset, of_arc__design_slack(of, $bound(rule, "wrap_factor"))));
} else {
if (!($truth(binding) && $truth(criteria.standard.name))) {
return null;
}
}
yield new Figure("design_standard", ("" + "T2 by " + $str(rule.name)), tension, $bound(of, "place"), binding);
}
function design_standard__find_requirement(standard, take_up, lagging, wrap_angle) {
let factor, found, friction;

if (($eq(standard.name, "none"))) {
return null;
}
if ($truth(design_standard__by_table(standard, take_up, lagging))) {
return design_standard___manual(lagging, wrap_angle);
}
([friction, found] = design_standard___friction(standard, lagging));
if ((friction == null)) {
return found;
}
(factor = constant_friction__wrap_factor(friction, wrap_angle));
return $replaced(found, new Map([["wrap_factor", ($truth(design_standard__prints(standard, $bound(lagging, "surface"))) ? numbers__as_printed(factor) : factor)]]));
}
function design_standard__by_table(standard, take_up, lagging) {

return $and(design_standard___cema(standard), () => $and(take_up.fixed, () => $b.bool($bound(lagging, "surface"))));
}
function design_standard___cema(standard) {
return $and((standard.friction == null), () => ($eq($or(standard.name, () => "CEMA"), "CEMA")));
}
function design_standard___manual(lagging, wrap_angle) {
let angle, end, ends, factor, rows, why;
(rows = design_standard___rows(lagging));
(angle = $math.degrees(wrap_angle));
if (!($sub($at($at(rows, 0), 0), 1e-09) <= angle && angle <= $add($at($at(rows, $neg(1)), 0), 1e-09))) {
(ends = ("" + $format($at($at(rows, 0), 0), ("" + "g")) + " to " + $format($at($at(rows, $neg(1)), 0), ("" + "g")) + " deg"));
(end = ((angle < $at($at(rows, 0), 0)) ? ("" + "from " + $format($at($at(rows, 0), 0), ("" + "g"))) : ("" + "to " + $format($at($at(rows, $neg(1)), 0), ("" + "g")))));
(why = ("" + "wrap " + $format(angle, ("" + ".4g")) + " deg, manual take-up factors " + $str(end) + " deg"));
return design_standard___silent("CEMA", why, ("" + "Use a wrap of " + $str(ends) + ", or set design_standard.friction."));
}
(factor = $b.next((function* () { for (const [row, value] of $iter($b.reversed(rows))) { if (!((row <= $add(angle, 1e-09)))) continue; yield value; } })()));
return new StandardRequirement("CEMA", ("" + "manual take-up, Cw " + $format(factor, ("" + "g"))), factor, "CEMA, Belt Conveyors for Bulk Materials (5th edition, table 6-8)");
}
function design_standard___rows(lagging) {
return $at($c5f1f, (($eq(lagging.surface, "bare")) ? "bare" : "lagged"));
}
function design_standard___silent(name, why, remedy = "Set design_standard.friction.") {
return new StandardRequirement(name, "", NaN, "", why, remedy);
}
function design_standard___friction(standard, lagging) {
let condition, found, friction, how, name, stated, value;

(name = $or(standard.name, () => "CEMA"));
if ((standard.friction != null)) {
(how = ("" + "friction " + $format(standard.friction, ("" + ".2f"))));
return [standard.friction, new StandardRequirement("design standard", how, NaN, "input")];
}
if (!$truth(lagging.surface)) {
return [null, design_standard___silent(name, ("" + $str(lagging.name) + " has no surface"))];
}
(condition = $or(standard.condition, () => lagging.condition));
(found = [...(function* () { for (const d of $iter((() => $c9375)())) { if (!((($eq(d.standard, name)) && ($eq(d.surface, lagging.surface))))) continue; yield d; } })()]);
(value = $b.next((function* () { for (const d of $iter(found)) { if (!(($in(d.condition, ["", condition])))) continue; yield d; } })(), null));
if ((value == null)) {
return [null, design_standard___silent(name, ("" + "no value for " + $str(lagging.surface) + ", " + $str(condition)))];
}
(friction = $at(value.friction, 0));
(stated = $m.join(", ", (function* () { for (const part of $iter([value.surface, value.condition])) { if (!($truth(part))) continue; yield part; } })()));
(how = ("" + "friction " + $format(friction, ("" + ".2f")) + " (" + $str(stated) + ")"));
return [friction, new StandardRequirement(name, how, NaN, $b.str($bound(value, "provenance")))];
}
function constant_friction__wrap_factor(friction, wrap_angle) {

return (1.0 / $math.expm1($mul(friction, wrap_angle)));
}
function design_standard__prints(standard, surface) {

return $and(design_standard___cema(standard), () => ($in(surface, ["bare", "rubber"])));
}
function numbers__as_printed(factor) {

return $b.min(factor, ($math.floor($add($mul(100.0, factor), 0.5)) / 100.0));
}
function of_arc__design_slack(of, factor) {
let start;

(start = of_arc__start_factor($bound(of.drive, "criteria"), $bound(of.case, "kind")));
return numbers__required_slack(factor, start, $bound($at(of.case.tensions, of.pulley.name), "effective"));
}
function of_arc__start_factor(criteria, kind) {

return (($eq(kind, "running")) ? criteria.standard.start_factor : 1.0);
}
function numbers__required_slack(factor, start, pull) {

return $mul($mul(factor, start), $b.abs(pull));
}
function least_tension___gross_slip(drive, case_, arcs, index, end) {
let arc, factor, raised, rise, title;

([arc, factor] = [$at(arcs, index).arc, drive.criteria.safety.of($bound(case_, "kind"))]);
(rise = gross_slip__rises([...(function* () { for (const r of $iter(arcs)) { yield r.arc; } })()], index, $bound(drive.criteria, "take_up")));
(raised = in_page_checks__lift($at(arcs, index), factor, $bound(rise, "tight")));
(title = ("" + "Gross-slip safety " + $format(factor, ("" + "g"))));
(raised = ($truth($math.isnan(raised)) ? Infinity : raised));
return new Figure("gross_slip", title, $add(end, raised), new Place($bound(arc, "pulley"), $bound(case_, "name")));
}
function in_page_checks__lift(result, _factor, _tight_rise) {

return result.found.lift;
}
function* least_tension___of_tension(rule, of, end) {
let rise, text;

(text = $and(rule.text, () => rule.text(of)));
if ((!$truth(least_tension__is_of_tension(rule)) || (text == null) || $truth(text.missing) || $truth(text.why))) {
return null;
}
(rise = rule.rise_to($bound(of, "state"), rule.limit_at(of)));
yield new Figure($bound(rule, "name"), $bound(text, "title"), $add(end, rise), $bound(of, "place"), undefined, ($eq(rule.tension, "raise")));
}
function least_tension__is_of_tension(rule) {

return $and($b.bool($bound(rule, "tension")), () => $and((rule.firm == null), () => (rule.value != null)));
}
function least_tension__taut(conveyor) {
let ends, slackest, tension;

(ends = $map([...(function* () { for (const s of $iter(conveyor.reckoned())) { yield [s.name, $b.min($bound(s, "head"), $bound(s, "tail"), $bound(s, "entry"), $bound(s, "exit"))]; } })()]));
(slackest = alike__least(ends, ((name) => $at(ends, name))));
(tension = $add($sub(conveyor.take_up, $at(ends, slackest)), 1.0));
return new Figure("taut", "T2 for taut belt", tension, new Place("", slackest));
}
function alike__least(items, key) {

return alike__largest(items, ((item) => $neg(key(item))));
}
function alike__largest(items, key) {
let every, found, item, most, number;

(every = [...(function* () { for (const item of $iter(items)) { yield [key(item), item]; } })()]);
if (!$truth(every)) {
throw new $ValueError("nothing to choose from");
}
([most, found] = $at(every, 0));
for ([number, item] of $iter($slice(every, 1, null))) {
if (((number > most) && !$truth($math.isclose(number, most, ({rel_tol: 1e-09}))))) {
([most, found] = [number, item]);
}
}
return found;
}
function least_tension___tension(figure) {
return figure.tension;
}
function least_tension__least_sentence(result) {
let found, governs, now, where;

(found = least_tension__least_tension(result));
if ((found == null)) {
return "";
}
if ($truth($math.isinf($bound(found, "tension")))) {
return least_tension___none(found, result);
}
(governs = found.governing);
(where = $m.join(", ", (function* () { for (const part of $iter([governs.title, $b.str($bound(governs, "place"))])) { if (!($truth(part))) continue; yield part; } })()));
(now = cellOf($bound(found, "given"), "force", undefined, "typed", undefined, "tension"));
return ("" + "Minimum " + $str(least_tension__least_name(result)) + " " + $str(least_tension__at_least($bound(found, "tension"))) + " (" + $str(where) + "); now " + $str(now) + ".");
}
function least_tension___none(found, result) {
let governs, name, top;
([governs, top, name] = [found.governing, found.highest, least_tension__least_name(result)]);
if (($truth($math.isinf($bound(governs, "tension"))) && ($eq(governs.name, "design_standard")))) {
return ("" + "No " + $str(name) + " passes: " + $str(governs.title) + " does not apply" + $str(governs.place.bracket) + ".");
}
if (($truth($math.isinf($bound(governs, "tension"))) || (top == null))) {
return ("" + "No " + $str(name) + " in the tested pressure range meets " + $str($at($c1dc5, governs.name).what) + $str(governs.place.bracket) + ".");
}
return ("" + "No " + $str(name) + " passes: " + $str(governs.title) + " needs " + $str(least_tension__at_least($bound(governs, "tension"))) + ", " + $str(top.title) + " allows " + $str(least_tension__at_most($bound(top, "tension"))) + ".");
}
function least_tension__least_name(result) {
let one;

(one = ($truth($b.isinstance(result, TrainResult)) ? result.drive_result() : result));
return ($truth(one.drive.take_up_place) ? least_tension__tension_at($bound(one.drive, "take_up_place")) : least_tension__slack_name($bound(one, "drive")));
}
function least_tension__tension_at(place) {

return ($truth(place) ? ("" + "tension " + $str(place)) : "T2");
}
function least_tension__slack_name(drive) {
let case_, driving;

(case_ = drive.load_case());
(driving = ($eq(drive.slack_end(case_), $at(case_.tensions, $at(drive.pulleys, $neg(1)).name).exit)));
return ($truth(driving) ? "T2" : "slack-side tension T1");
}
function least_tension__at_least(tension) {

return cellOf(tension, "force", 3, "up", undefined, "tension");
}
function least_tension__at_most(tension) {

return cellOf(tension, "force", 3, "down", undefined, "tension");
}
function least_tension__least_table(result) {
let counts, figure, found, heads, least, name, note, now, rows, status, symbol, text, weight;

(found = least_tension__least_tension(result));
if ((found == null)) {
return null;
}
([rows, name] = [[], least_tension__least_name(result)]);
if (!$truth($math.isinf($bound(found, "tension")))) {
(weight = cellOf($bound(found, "counterweight"), "mass", 3, "up"));
(now = ("" + "now " + $str(cellOf($bound(found, "given"), "force", undefined, "typed", undefined, "tension"))));
(least = least_tension__at_least($bound(found, "tension")));
(symbol = (($eq(name, "T2")) ? "T2_min" : ""));
$m.append(rows, new Row(("" + "Minimum " + $str(name)), [least, "", now], symbol, undefined, "minimum_tension"));
(status = "if the take-up is a weight");
$m.append(rows, new Row("Counterweight", [weight, "", status], undefined, undefined, "counterweight"));
}
for (figure of $iter($b.sorted($bound(found, "figures"), $k({key: ((f) => [!$truth(f.at_least), $neg(f.tension)])})))) {
(text = ($truth(figure.at_least) ? least_tension__at_least($bound(figure, "tension")) : ("" + "max " + $str(least_tension__at_most($bound(figure, "tension"))))));
(text = ($truth($math.isinf($bound(figure, "tension"))) ? "none" : text));
(counts = $or(($in(figure, found.required)), () => !$truth(figure.at_least)));
(status = ($truth(counts) ? "" : "not counted: no tension passes"));
(status = ((figure === found.governing) ? "governs" : status));
$m.append(rows, new Row($bound(figure, "title"), [text, $b.str($bound(figure, "place")), status], undefined, undefined, figure.name));
}
(heads = [("" + "Minimum " + $str(name)), "Place", "Status"]);
(note = $m.join(" ", least_tension___conditions(result)));
return new Table(("" + "Minimum " + $str(name) + " by check"), $b.tuple(rows), heads, note, "least");
}
function* least_tension___conditions(result) {
let described;

if ($truth(least_tension__divides_anew(result))) {
yield "Computed at the load shares of now: another tension divides the load anew.";
}
(described = ($truth($b.isinstance(result, DriveResult)) ? result.drive : result.train));
if ($truth($b.any((function* () { for (const pulley of $iter(described.pulleys)) { yield pulley.across; } })()))) {
yield "Computed for even pulleys.";
}
}
function least_tension__divides_anew(result) {

return $and($b.isinstance(result, TrainResult), () => !$truth($b.all((function* () { for (const c of $iter(result)) { yield c.case.pulls_given; } })())));
}
function least_tension__shown_least(result) {
let found;

(found = least_tension__least_tension(result));
return ((found == null) ? "-" : ($truth($math.isinf($bound(found, "tension"))) ? "none" : least_tension__at_least($bound(found, "tension"))));
}
function checks_table__check_table(verdict, of = null, title = "Checks") {
let judged;

(judged = [...(function* () { for (const c of $iter(verdict.listed)) { if (!($truth(c.compares))) continue; yield c; } })()]);
return new Table(title, $b.tuple((function* () { for (const check of $iter(judged)) { yield checks_table___row(check, of); } })()), $c80d9, $m.join(" ", (function* () { for (const text of $iter(["Used: value over a maximum, or a minimum over the value. Each check at its governing place.", checks_table___not_checked(verdict, ": ")])) { if (!($truth(text))) continue; yield text; } })()), "checks", checks_table___nearest(verdict, title), checks_table___not_checked(verdict, "  "));
}
function checks_table___row(check, of) {
let _, note, number, value, values;
([value, _] = check.texts());
(values = [$or(value, () => "-"), $or(check.bound(), () => "-"), checks_table__used_text(check), $b.str($bound(check, "level"))]);
(number = ((of == null) ? "" : of.number($bound(check, "source"))));
(note = $m.join(" ", (function* () { for (const part of $iter([$b.str($bound(check, "place")), number])) { if (!($truth(part))) continue; yield part; } })()));
return new Row($bound(check, "title"), values, undefined, note, check.name, check.level);
}
function checks_table__used_text(check) {
let used;

(used = check.used);
if ((used > $sub(10.0, 0.001))) {
return ("" + "> " + $format(10.0, ("" + "g")) + " times");
}
return ($truth($math.isfinite(used)) ? cell__percent(used) : "-");
}
function checks_table___not_checked(verdict, apart) {
let left, named;

(left = [...(function* () { for (const c of $iter(verdict.not_checked)) { if (!((!$eq(c.name, "wet_creep")))) continue; yield c; } })()]);
(named = $m.join(", ", (function* () { for (const c of $iter(left)) { yield ("" + $str($or(c.noun, () => c.title)) + " (" + $str($or(c.missing, () => c.why)) + ")"); } })()));
return ($truth(named) ? ("" + "Not checked" + $str(apart) + $str(named) + ".") : "");
}
function checks_table___nearest(verdict, title) {
let rows, told;

(told = [...(function* () { for (const c of $iter(verdict.listed)) { if (!(($truth(c.compares) && ($truth(c.missed) || $truth($math.isfinite($bound(c, "used"))))))) continue; yield c; } })()]);
(told = $b.sorted((function* () { for (const c of $iter(told)) { if (!(!$truth(c.below))) continue; yield c; } })(), $k({key: ((check) => check.order)})));
(rows = $b.tuple((function* () { for (const c of $iter($slice(told, null, $b.max(4, $b.len($bound(verdict, "missed")))))) { yield checks_table___row(c, null); } })()));
return new Table(title, rows, $c80d9, undefined, "checks");
}
function words__short(result, arc) {
let worst;

if ((arc.status === "Gross slip: no creep gives enough friction for this tension ratio. Raise the slack-side tension (take-up), increase the wrap angle, or choose a lagging with more friction.")) {
return ("" + $str("FAILS") + " gross slip");
}
(worst = judge__judge(result).at($bound(arc.arc, "pulley"), $bound(arc.arc, "load_case")).governing);
if (((worst != null) && $truth(worst.missed))) {
return ("" + $str(worst.level) + " " + $str(worst.label));
}
return ($truth(rule__idle($bound(arc, "arc"))) ? "OK, not driven" : $b.str("OK"));
}
function words__order_in(judged) {
let worst;

(worst = judged.governing);
return ((worst == null) ? 0.0 : $b.max($neg(1000000000000.0), $b.min($at(worst.order, 1), 1000000000000.0)));
}
function drive_sheet__summary_table(results, whole) {
let arc, brakes, heads, of, result, rows, title, values;

(brakes = $b.any((function* () { for (const result of $iter(results)) { for (const arc of $iter(result)) { yield (arc.arc.side < 0.0); }} })()));
(heads = [sheet__headed("T1", "force"), sheet__headed("T2", "force"), "T1/T2", sheet__headed("creep", "length"), "of limit", sheet__headed(($truth(brakes) ? "min. T1" : "min. T2"), "force"), ""]);
(rows = []);
for ([result, of] of $iter($b.zip(results, [whole, ...$iter($slice(results, 1, null))], $k({strict: true})))) {
for (arc of $iter(result)) {
(title = drive_sheet___title_of(arc, ($b.len(results) > 1)));
(values = [...$iter(drive_sheet___summary_values(result, arc)), words__short(of, arc)]);
$m.append(rows, new Row(title, values, undefined, undefined, undefined, words__level_of(of, arc)));
}
}
return new Table("All load cases and pulleys", $b.tuple(rows), heads, undefined, "cases");
}
function sheet__headed(words, dimension) {

return (($eq(dimension, "number")) ? words : ("" + $str(words) + " [" + $str(cell__unit_of(dimension)) + "]"));
}
function cell__unit_of(dimension) {

return cellOf(0.0, dimension, undefined, "unit");
}
function drive_sheet___title_of(arc, several) {
let method;

(method = ($truth(several) ? ("" + ", " + $str($at($c9028, arc.method))) : ""));
return ("" + $str(arc.arc.load_case) + ": " + $str(arc.arc.pulley) + $str(method));
}
function drive_sheet___summary_values(of, result) {
let arc;
(arc = result.arc);
return [sheet__number("entry_tension", $bound(arc, "entry_tension")), sheet__number("exit_tension", $bound(arc, "exit_tension")), sheet__number("tension_ratio", (arc.entry_tension / arc.exit_tension)), sheet__number("exit_creep", $bound(result, "exit_creep")), cell__percent($bound(result, "share_of_limit")), drive_sheet___least(of, result)];
}
function sheet__number(name, value) {

return cell__bare(value, $bound(term(name), "dimension"), 3, name);
}
function cell__bare(value, dimension, digits = 3, name = "") {

if (!$truth($math.isfinite(value))) {
return cell__quantity(value, dimension);
}
return cellOf(value, dimension, digits, "bare", undefined, name);
}
function drive_sheet___least(of, result) {
let found;

if (($b.len($bound(of.drive, "pulleys")) > 1)) {
return "-";
}
(found = least_tension__least_tension(words__alone_of(of, result)));
if ((found == null)) {
return "-";
}
if ($truth($math.isinf($bound(found, "tension")))) {
return "none";
}
return cellOf($bound(found, "tension"), "force", 3, "bare up", undefined, "tension");
}
function words__alone_of(result, arc) {
let known;

(known = $m.setdefault($c450e, result, $map([])));
if ((!$in(arc, known))) {
$put(known, arc, words__alone($bound(result, "drive"), arc));
}
return $at(known, arc);
}
function words__alone(drive, arc) {
let case_, criteria, name, own, own_case, pulley, solved, take_up, tensions;

([name, solved] = [arc.arc.load_case, arc.arc]);
(tensions = new Tensions(solved.entry_tension, solved.exit_tension));
(own = $b.next((function* () { for (const case_ of $iter(drive.load_cases)) { if (!(($eq(case_.name, name)))) continue; yield case_; } })(), null));
(case_ = new LoadCase(name, $map([[arc.arc.pulley, tensions]]), ($truth(own) ? own.kind : "running"), ($truth(own) ? own.condition : "")));
(pulley = drive.pulley($bound(arc.arc, "pulley")));
([criteria, take_up] = [drive.criteria, drive.criteria.take_up]);
if ((!$in(take_up.after, ["", pulley.name]))) {
(criteria = $replaced(criteria, new Map([["take_up", $replaced(take_up, new Map([["after", ""]]))]])));
}
(own_case = $replaced(drive, new Map([["criteria", criteria], ["pulleys", [pulley]], ["load_cases", [case_]], ["conveyor", null]])));
return new DriveResult(own_case, [arc]);
}
function words__level_of(result, arc) {

return judge__judge(result).at($bound(arc.arc, "pulley"), $bound(arc.arc, "load_case")).level;
}
function drive_sheet__arc_tables(result, results, of) {
let carried, case_, drive, first, found, lagging, solved;

([first, drive] = [$at(results, 0), result.drive]);
(case_ = drive.load_case($bound(first.arc, "load_case")));
(lagging = drive.pulley($bound(first.arc, "pulley")).lagging_in($bound(case_, "condition")));
(solved = $b.tuple((function* () { for (const other of $iter(results)) { if (!($truth($told($cc303, other.status, "solved")))) continue; yield other; } })()));
(carried = $told($cc303, first.status, "solved"));
(found = $map([["answer", ($truth(solved) ? arc_tables__answer_table(solved) : null)], ["creep", ($truth(solved) ? arc_tables__creep_table(solved) : null)], ["capacity", arc_tables__capacity_table(first)], ["margins", in_page_checks__no_table(result, first)], ["comparison", design_values__comparison_table(first, lagging, of)], ["energy", ($truth(carried) ? arc_tables__energy_table(first) : null)], ["loads", drive_sheet__loads_table(new DriveResult(drive, [first]))], ["wear", ($truth(carried) ? in_page_checks__no_table(first, lagging) : null)], ["life", ($truth(carried) ? wear_table__life_table(first, lagging, of) : null)], ["inputs", input_tables__input_table(drive, $bound(first, "arc"), of)]]));
return $map([...(function* () { for (const [key, table] of $iter($m.items(found))) { if (!((table != null))) continue; yield [key, table]; } })()]);
}
function arc_tables__answer_table(results) {
let first, level, note, notes, pressure, rows, share, sides, told, where;

function row(name, note = "", level = null) {
let values;
(values = (function* () { for (const result of $iter(results)) { yield $b.getattr(result, name); } })());
return $call(sheet__row_of, [name, ...$iter(values)], [["note", note], ["level", level]]);
}
$sig(row, ["name", "note", "level"], false);
(first = $at(results, 0));
(share = ("" + $str(cell__percent($bound(first, "share_of_limit"))) + " of the limit"));
(notes = [("" + $str(share) + ", " + $str(sheet__named("creep_limit", $bound(first.arc, "creep_limit"))))]);
(notes = $add(notes, ((first.exit_creep < 0.0) ? ["negative: with the belt"] : [])));
(notes = $add(notes, ($truth((told = arc_tables__creep_interval_text(first))) ? [told] : [])));
([level, sides] = [arc_tables___creep_level(first), new Set((function* () { for (const r of $iter(results)) { if (!($truth($told($cc303, r.status, "solved")))) continue; yield r.within_creep_limit; } })())]);
if (($b.len(sides) > 1)) {
$m.append(notes, "the methods differ in whether it passes");
(level = ((level === "OK") ? "ATTENTION" : level));
}
(where = ("" + "at " + $str(sheet__named("peak_shear_position", $bound(first, "peak_shear_position"))) + " from the entry"));
(pressure = new Row("Wrap pressure, entry to exit", arc_tables___values(results, arc_tables___pressures), "p", undefined, "wrap_pressures"));
(rows = [row("exit_creep", $m.join("; ", notes), level), row("exit_slip"), row("peak_shear_angle", where), row("peak_shear_stress"), pressure, row("mean_friction", "equivalent constant friction over the whole wrap"), row("active_arc", "exit part over which 99 % of the tension change takes place"), ...$iter((!$truth($math.isnan($bound(first, "k_factor"))) ? [row("k_factor", "belt modulus x width / active arc (equation 7 of the paper)")] : []))]);
if ($truth($b.any((function* () { for (const result of $iter(results)) { yield result.sticks; } })()))) {
$m.append(rows, row("stuck_arc", "entry part where the belt does not slip"));
}
if (!$truth($b.all((function* () { for (const result of $iter(results)) { yield $math.isnan($bound(result, "outside_tested_share")); } })()))) {
$m.append(rows, arc_tables___outside_row(results));
}
(note = "belt slower than the lagging surface, entry to exit");
if ((first.exit_creep_ratio < 0.0)) {
(note = "negative: belt faster than the lagging surface, entry to exit");
}
$m.append(rows, new Row("Creep ratio", arc_tables___values(results, arc_tables___creep_ratios), "g", note, "creep_ratio"));
(rows = $add(rows, [...(function* () { for (const figure of $iter(key_figures__further_figures())) { yield arc_tables___key_row(results, $bound(figure, "name")); } })()]));
return new Table(("" + "Result: " + $str(arc_tables__belongs(first))), $b.tuple(rows), arc_tables__heads(results), undefined, "result");
}
function sheet__row_of(name, ...values) {
let cells, entry;
const {note: note = "", title: title = "", level: level = null} = $named(values);

(entry = term(name));
(cells = $b.tuple((function* () { for (const value of $iter(values)) { yield sheet__named(name, value); } })()));
return new Row($or(title, () => entry.title), cells, $bound(entry, "symbol"), note, name, level);
}
function sheet__named(name, value) {

return cell__quantity(value, $bound(term(name), "dimension"), 3, name);
}
function arc_tables__creep_interval_text(result) {
let end, high, low;

([low, high] = result.creep_interval);
if ($truth($math.isnan(low))) {
return "";
}
if (($truth($math.isinf(high)) || $truth($math.isinf(low)))) {
(end = ($truth($math.isinf(high)) ? low : high));
return ("" + "95 % by the law: from " + $str(sheet__named("exit_creep", end)) + " to gross slip");
}
return ("" + "95 % by the law: " + $str(sheet__between("exit_creep", low, high)));
}
function sheet__between(name, first, last, form = "to") {

return cellOf(last, $bound(term(name), "dimension"), 3, form, first, name);
}
function arc_tables___creep_level(result) {
if (!$truth($told($cc303, result.status, "solved"))) {
return null;
}
return ($truth(result.within_creep_limit) ? "OK" : "ATTENTION");
}
function arc_tables___pressures(result) {
let arc, first, last;
(arc = result.arc);
([first, last] = [arc.wrap_pressure($bound(result, "entry_tension")), arc.wrap_pressure($bound(result, "exit_tension"))]);
return sheet__between("wrap_pressure", first, last);
}
function arc_tables___values(results, of) {
return $b.tuple((function* () { for (const result of $iter(results)) { yield of(result); } })());
}
function arc_tables___outside_row(results) {
let level, note, outside, texts, title;
(texts = arc_tables___values(results, ((r) => ("" + $str(cell__percent($bound(r, "outside_tested_share"))) + " of the wrap"))));
(outside = $b.any((function* () { for (const result of $iter(results)) { yield result.extrapolates; } })()));
(note = ($truth(outside) ? "the friction law is an extrapolation there" : ""));
(level = ($truth(outside) ? "ATTENTION" : null));
(title = sheet__row_of("outside_tested_share", 0.0).title);
return new Row(title, texts, "", note, "outside_tested_share", level);
}
function arc_tables___creep_ratios(result) {
return ("" + $str(cell__percent($bound(result, "entry_creep_ratio"))) + " to " + $str(cell__percent($bound(result, "exit_creep_ratio"))));
}
function key_figures__further_figures() {

return [...(function* () { for (const figure of $iter($c3b87)) { if (!((!$in(figure.name, $c4e7c)))) continue; yield figure; } })()];
}
function arc_tables___key_row(results, name) {
return sheet__row_of(name, ...$iter((function* () { for (const result of $iter(results)) { yield figureOf(result, name); } })()));
}
function arc_tables__belongs(result) {

return ("" + "pulley " + $str(result.arc.pulley) + ", load case " + $str(result.arc.load_case));
}
function arc_tables__heads(results) {

if ((($eq($b.len(results), 1)) && ($eq($at(results, 0).method, "distributed")))) {
return [""];
}
return $b.tuple((function* () { for (const r of $iter(results)) { yield $m.get($c9028, $bound(r, "method"), $bound(r, "method")); } })());
}
function arc_tables__creep_table(results) {
let name, note, row, rows, texts;

(rows = []);
for ([name, note] of $iter([["creep_shrinkage", "the belt sheds tension and shortens"], ["creep_compression", "the lagging is compressed at the entry and recovers"], ["creep_global", "the whole belt slips back: what the friction needs in addition to the first two"]])) {
(texts = arc_tables___values(results, ((r) => arc_tables__creep_part(r, name))));
(row = sheet__row_of(name, 0.0));
$m.append(rows, new Row($bound(row, "title"), texts, $bound(row, "symbol"), note, name));
}
$m.append(rows, sheet__row_of("exit_creep", ...$iter((function* () { for (const r of $iter(results)) { yield r.exit_creep; } })())));
return new Table("Creep by source", $b.tuple(rows), arc_tables__heads(results), undefined, "creep");
}
function arc_tables__creep_part(result, name) {
let part, parts;

(part = $b.getattr(result, name));
(parts = [result.creep_shrinkage, result.creep_compression, result.creep_global]);
if ((($eq(result.exit_creep, 0.0)) || ($b.sum($b.map($b.abs, parts)) > $mul(1.05, $b.abs($bound(result, "exit_creep")))))) {
return sheet__named(name, part);
}
return ("" + $str(sheet__named(name, part)) + " (" + $str(cell__percent((part / result.exit_creep), 2)) + ")");
}
function arc_tables__capacity_table(result) {
let actual, arc, c, gross, held, note, ratio_now, rows, slack, slip, tight;

([c, arc] = [result.capacities, result.arc]);
if (($truth($math.isnan($bound(c, "gross_slip_capacity"))) && $truth($math.isnan($bound(c, "creep_limit_capacity"))))) {
return null;
}
([tight, slack] = ((arc.side > 0.0) ? ["T1", "T2"] : ["T2", "T1"]));
(held = sheet__named("tension", $b.max($bound(arc, "entry_tension"), $bound(arc, "exit_tension"))));
(ratio_now = (arc.entry_tension / arc.exit_tension));
(actual = $b.max(ratio_now, (1.0 / ratio_now)));
function row(name, value, note) {
return new Row($bound(term(name), "title"), [sheet__named(name, value)], $bound(term(name), "symbol"), note, name);
}
$sig(row, ["name", "value", "note"], false);
function ratio(name, value, margin, note) {
let shown;
(shown = ($truth($math.isnan(margin)) ? "" : ("" + "margin " + $str(sheet__named("tension_ratio", margin)) + "; ")));
return row(name, value, ("" + $str(shown) + $str(note)));
}
$sig(ratio, ["name", "value", "margin", "note"], false);
(rows = [ratio("creep_limit_capacity", $bound(c, "creep_limit_capacity"), $bound(c, "creep_limit_margin"), "the design number"), row("equivalent_friction", $bound(c, "equivalent_friction"), "compare with design values")]);
if ((arc.law.tested != null)) {
(slip = sheet__named("slip", $bound(arc.law.tested, "slip_max")));
(note = ("" + "slip at the maximum tested, " + $str(slip)));
$m.append(rows, ratio("tested_slip_capacity", $bound(c, "tested_slip_capacity"), $bound(c, "tested_slip_margin"), note));
}
(gross = arc_tables___gross_note(arc_tables__independent_of_slip($bound(arc, "law")), $bound(c, "gross_slip_creep")));
$m.append(rows, row("gross_slip_capacity", $bound(c, "gross_slip_capacity"), gross));
(note = ("" + "Ratios " + $str(tight) + "/" + $str(slack) + " at constant " + $str(tight) + " of " + $str(held) + "; margin is the capacity over the actual ratio, " + $str(sheet__named("tension_ratio", actual)) + "."));
return new Table("Capacity", $b.tuple(rows), undefined, note, "capacity");
}
function arc_tables__independent_of_slip(law) {

return $b.isinstance(law, Constant, PressurePower);
}
function arc_tables___gross_note(plain, creep) {
if ($truth(plain)) {
return "the whole wrap slips";
}
if ($truth($math.isinf(creep))) {
return "extrapolated, approached as creep grows to infinity";
}
return ("" + "extrapolated, at " + $str(sheet__named("gross_slip_creep", creep)) + " of creep");
}
function in_page_checks__no_table(..._of) {

}
function design_values__comparison_table(result, lagging, of) {
let arc, asked, c, given, heads, limit, mean, note, ratio, ratio_head, rows;

([arc, c] = [result.arc, result.capacities]);
(given = $b.min($bound(arc, "entry_tension"), $bound(arc, "exit_tension")));
(ratio = ($b.max($bound(arc, "entry_tension"), $bound(arc, "exit_tension")) / given));
(mean = ($math.log(ratio) / arc.wrap_angle));
(asked = design_values___texts(mean, ratio, given, ($truth(mean) ? arc.wrap_angle : 0.0)));
(rows = [new Row("This load, whole wrap slipping", asked, undefined, undefined, "load")]);
if (!$truth($math.isnan($bound(c, "equivalent_friction")))) {
(limit = design_values___texts($bound(c, "equivalent_friction"), $bound(c, "creep_limit_capacity"), $bound(c, "least_exit_tension"), NaN));
$m.append(rows, new Row("At the creep limit, as computed", limit, undefined, undefined, "at_creep_limit"));
}
(rows = $add(rows, [...(function* () { for (const classical of $iter(design_values__known(result, lagging))) { yield design_values___design_row(classical, result, of); } })()]));
if ($truth(lagging.surface)) {
(note = "T2: Cw (T1 - T2) with Cw = 1/(exp(mu phi) - 1). Slipping arc: ln(T1/T2)/mu. Design values are constant and take no account of creep.");
} else {
(note = "Surface of the lagging missing: no design values apply.");
}
(ratio_head = ((arc.side > 0.0) ? "T1/T2 up to" : "T2/T1 up to"));
(heads = ["friction", ratio_head, "T2", "slipping arc"]);
return new Table("Compared with constant friction", $b.tuple(rows), heads, note, "constant");
}
function design_values___texts(mu, ratio, slack, arc) {
return [cell__quantity(mu, "number"), sheet__named("tension_ratio", ratio), sheet__named("tension", slack), sheet__named("active_arc", arc)];
}
function design_values__known(result, lagging) {

return constant_friction__classical_drives($bound(result, "arc"), lagging);
}
function constant_friction__classical_drives(arc, lagging) {
let known;

(known = [...(function* () { for (const value of $iter((() => $c9375)())) { if (!(($eq(value.surface, lagging.surface)))) continue; yield value; } })()]);
known.splice(0, Infinity, ...$b.sorted(known, $k({key: ((value) => (!$in(value.condition, ["", lagging.condition])))})));
return $b.tuple((function* () { for (const value of $iter(known)) { yield constant_friction___classical(arc, value); } })());
}
function constant_friction___classical(arc, value) {
let factors, high, low, phi, pull, ratio;
([low, high] = value.friction);
([phi, pull] = [arc.wrap_angle, $b.abs($bound(arc, "effective_tension"))]);
(ratio = (arc.entry_tension / arc.exit_tension));
(factors = [constant_friction__wrap_factor(low, phi), constant_friction__wrap_factor(high, phi)]);
return new ClassicalDrive(value, [constant_friction__capstan_ratio(low, phi), constant_friction__capstan_ratio(high, phi)], factors, [$mul($at(factors, 0), pull), $mul($at(factors, 1), pull)], [constant_friction__slipping_arc(low, ratio), constant_friction__slipping_arc(high, ratio)]);
}
function constant_friction__capstan_ratio(friction, wrap_angle) {

return $math.exp($mul(friction, wrap_angle));
}
function constant_friction__slipping_arc(friction, tension_ratio) {

return ($b.abs($math.log(tension_ratio)) / friction);
}
function design_values___design_row(drive, result, of) {
let arc, design, high, level, low, note, slips, standard, title, values;
([design, arc] = [drive.design, result.arc]);
(standard = $add($m.upper($at(design.standard, 0)), $slice(design.standard, 1, null)));
(slips = ($at(drive.slipping_arc, 0) > arc.wrap_angle));
([low, high] = design.friction);
(values = [cellOf(high, "number", undefined, "-", low), design_values___pair("tension_ratio", $bound(drive, "ratio")), design_values___at_least(...$iter(drive.slack_tension)), ($truth(slips) ? "gross slip" : design_values___pair("active_arc", $bound(drive, "slipping_arc")))]);
(note = of.note($bound(design, "provenance")));
(title = $m.join(", ", (function* () { for (const part of $iter([standard, design.surface, design.condition])) { if (!($truth(part))) continue; yield part; } })()));
(level = ($truth(slips) ? "ATTENTION" : null));
return new Row(title, values, undefined, note, "design_value", level);
}
function design_values___pair(name, ends) {
return $call(sheet__between, [name, ...$iter(ends)], [["form", "-"]]);
}
function design_values___at_least(low, high) {

return (($sub(high, low) <= $mul(1e-09, high)) ? least_tension__at_least(high) : sheet__between("tension", low, high, "to up"));
}
function arc_tables__energy_table(result) {
let e, entry, needs, note, rows;

(e = result.energy);
(rows = [...(function* () { for (const name of $iter(["transmitted_power", "sliding_power", "shear_loss", "power_loss"])) { if (!(!$truth($math.isnan($b.getattr(e, name))))) continue; yield sheet__row_of(name, $b.getattr(e, name)); } })()]);
if (!$truth($math.isnan($bound(e, "efficiency")))) {
(entry = sheet__row_of("efficiency", 0.0));
$m.append(rows, new Row($bound(entry, "title"), [cell__percent($bound(e, "efficiency"), 4)], $bound(entry, "symbol"), "", "efficiency"));
}
(note = "what wears lagging and belt");
$m.append(rows, $call(sheet__row_of, ["frictional_energy", $bound(e, "frictional_energy")], [["note", note]]));
if (!$truth($math.isnan($bound(e, "wear_rate")))) {
$m.append(rows, sheet__row_of("wear_rate", $bound(e, "wear_rate")));
}
(needs = ($truth(result.arc.belt_speed) ? "" : "Give the belt speed to see powers."));
return new Table("Energy and wear", $b.tuple(rows), undefined, needs, "energy");
}
function drive_sheet__loads_table(result) {
let arc, belt, cells, drive, given, heads, note, of, rows, shown, strength, weighed;

([drive, belt, rows] = [result.drive, result.drive.belt, []]);
(weighed = [...(function* () { for (const p of $iter(drive.pulleys)) { if (!($truth(p.mass))) continue; yield ("" + $str(p.name) + " " + $str(cell__quantity($bound(p, "mass"), "mass", 4))); } })()]);
(strength = ((belt.breaking_strength == null) ? NaN : belt.breaking_strength));
for (arc of $iter(result)) {
(of = drive_sheet__loads_of(drive, $bound(arc, "arc")));
(cells = [sheet__named("resultant_force", $bound(of, "resultant_force")), sheet__named("resultant_angle", $bound(of, "resultant_angle")), sheet__named("belt_safety", $bound(of, "belt_safety")), sheet__named("most_shaft_load", $bound(of, "most_shaft_load")), sheet__named("least_shaft_load", $bound(of, "least_shaft_load"))]);
$m.append(rows, new Row(("" + $str(arc.arc.load_case) + ": " + $str(arc.arc.pulley)), $slice(cells, null, ($truth(weighed) ? 5 : 3))));
}
(note = "Resultant of the belt tensions for shaft and bearings, from the line of T1 towards that of T2, the weight of the pulley left out. ");
if ($truth(weighed)) {
(note = $add(note, ("" + "With the weight (" + $str($m.join(", ", weighed)) + "): maximum for a resultant straight down, minimum for one straight up; for a level one the root of the sum of both squares. ")));
}
if ((belt.breaking_strength == null)) {
(note = $add(note, "Safety factor of the belt: strength missing."));
} else {
(given = cell__quantity(strength, "force_per_width", 4));
(note = $add(note, ("" + "Safety factor: strength " + $str(given) + " over the larger tension; see the checks.")));
}
(heads = ["resultant", "direction", "belt", "with weight, most", "least"]);
(shown = $slice(heads, null, ($truth(weighed) ? 5 : 3)));
return new Table("Loads of pulleys and belt", $b.tuple(rows), shown, note, "loads");
}
function drive_sheet__loads_of(drive, of) {
let known, mass, strength;

([strength, mass] = [drive.belt.breaking_strength, drive.pulley($bound(of, "pulley")).mass]);
(known = [((strength == null) ? NaN : $mul(strength, of.width)), $or(mass, () => NaN)]);
return load_case__resultant($bound(of, "entry_tension"), $bound(of, "exit_tension"), $bound(of, "wrap_angle"), ...$iter(known));
}
function wear_table__life_table(result, lagging, of = null) {
let data, depth, k, life, note, passes, rows, source, years;

(data = wear_table___life_of(result, lagging));
if ((data == null)) {
return null;
}
(passes = cell__quantity($at(data, "passes_per_hour"), "number"));
(rows = [new Row("Passes of the lagging under the belt", [("" + $str(passes) + " 1/h")], undefined, undefined, "passes_per_hour")]);
(depth = cell__quantity($at(data, "depth"), "length"));
if (($at(data, "life_hours") != null)) {
(k = cell__quantity($at(data, "coefficient"), "wear_coefficient"));
(source = $b.str(lagging.source_of("wear_coefficient")));
$m.append(rows, new Row("Wear coefficient", [k], undefined, source, "wear_coefficient"));
(life = wear_table___life($at(data, "life_hours")));
(years = ("" + "frictional energy times wear coefficient; a year has " + $format(6000.0, ("" + "g")) + " h of running here"));
$m.append(rows, new Row(("" + "Life until " + $str(depth) + " is worn off"), [life], undefined, years, "life"));
}
(rows = $add(rows, [...(function* () { for (const vendor of $iter($at(data, "vendors"))) { yield wear_table___vendor_row(vendor, of); } })()]));
(note = ("" + "Depth that may be worn off: half the thickness, " + $str(depth) + "."));
if (($at(data, "life_hours") == null)) {
(note = $add(note, " The life follows from a wear coefficient, which is not published: calibrate it to a measured wear (wraparc field --measured-wear), or give wear_coefficient."));
}
return new Table("Life of the lagging", $b.tuple(rows), undefined, note, "life");
}
function wear_table___life_of(result, lagging) {
let depth, energy, k, passes, speed;
([speed, depth] = [result.arc.belt_speed, $mul(0.5, lagging.thickness)]);
(energy = $b.abs($bound(result.energy, "frictional_energy")));
if (((speed == null) || !$truth($told($cc303, result.status, "solved")) || (depth <= 0.0) || !(energy > 1e-09))) {
return null;
}
(passes = pitch__turns_an_hour(speed, $add(result.arc.radius, result.arc.offset)));
(k = lagging.wear_coefficient);
return $map([["passes_per_hour", passes], ["frictional_energy", energy], ["belt_energy_share", lagging.belt_energy_share], ["depth", depth], ["coefficient", k], ["life_hours", ((k == null) ? null : wear__wear_life(depth, k, energy, passes))], ["vendors", $b.list(wear_table___vendors(lagging, depth, energy, passes))]]);
}
function pitch__turns_an_hour(speed, pitch) {

return ($mul(3600.0, speed) / $mul($mul(2.0, 3.141592653589793), pitch));
}
function wear__wear_life(depth, coefficient, energy, passes) {
let worn;

(worn = $mul($mul(coefficient, $b.abs(energy)), passes));
return ((worn > 0.0) ? (depth / worn) : Infinity);
}
function* wear_table___vendors(lagging, depth, energy, passes) {
let ends, high, low, row;
for (row of $iter((() => $c2342)())) {
if (($eq(row.surface, lagging.surface))) {
([low, high] = row.life_years);
(ends = (function* () { for (const y of $iter([high, low])) { yield wear__coefficient_of_life(depth, $mul(6000.0, y), energy, passes); } })());
yield $map([["name", row.name], ["years", [low, high]], ["coefficient", $b.list(ends)], ["source", $b.str($bound(row, "provenance"))]]);
}
}
}
function wear__coefficient_of_life(depth, hours, energy, passes) {
let worn;

(worn = $mul($mul(hours, $b.abs(energy)), passes));
return ((worn > 0.0) ? (depth / worn) : Infinity);
}
function wear_table___life(hours) {
if ($truth($math.isinf(hours))) {
return "-";
}
return $add(cell__quantity(hours, "number"), " h");
}
function wear_table___vendor_row(vendor, of) {
let ends, high, least, low, most, note, number, years;
([low, high] = $at(vendor, "coefficient"));
(ends = cellOf(high, "wear_coefficient", 3, "to", low));
([least, most] = $at(vendor, "years"));
(years = cellOf(most, "number", undefined, "to", least));
(years = (($eq(least, most)) ? ("" + "over " + $str(years)) : years));
(number = ((of == null) ? "" : of.number(("" + $str("life of a lagging as its vendor states it") + ": " + $str($at(vendor, "source"))))));
(note = ("" + "whatever the creep; here it would take a wear coefficient of " + $str(ends) + " " + $str(number)));
return new Row(("" + "Vendor's life, " + $str($at(vendor, "name"))), [("" + $str(years) + " years")], undefined, $m.strip(note), "vendor_life");
}
function input_tables__input_table(drive, arc, of) {
let title;

(title = ("" + "Inputs: pulley " + $str(arc.pulley) + ", load case " + $str(arc.load_case)));
return new Table(title, input_tables__input_rows(inputs__arc_inputs(drive, arc), of), undefined, undefined, "inputs");
}
function inputs__arc_inputs(drive, arc) {
let group, pull, pulley, ratio;

(pulley = drive.pulley($bound(arc, "pulley")).in_condition($bound(drive.load_case($bound(arc, "load_case")), "condition")));
([pull, ratio] = [arc.effective_tension, (arc.entry_tension / arc.exit_tension)]);
(group = ("" + "Load case " + $str(arc.load_case)));
return [...$iter(inputs__belt_inputs($replaced(drive.belt, new Map([["speed", arc.belt_speed]])))), ...$iter(inputs___pulley(drive, pulley, $bound(arc, "entry_overrun"))), ...$iter(inputs__lagging_inputs($bound(pulley, "lagging"))), ...$iter(inputs___tensions(drive, arc)), inputs___named(group, "effective_tension", pull, null, $bound(arc, "duty")), inputs___named(group, "tension_ratio", ratio, null)];
}
function* inputs__belt_inputs(belt) {
let group, key, layers, least, measured, most, name, origin_of, remark, shear;

(group = "Belt");
function origin(key) {
return $m.get(belt.sources, key, $bound(belt, "provenance"));
}
$sig(origin, ["key"], false);
function own(title, value, dimension, key) {
return new Input(group, title, value, dimension, "", origin(key));
}
$sig(own, ["title", "value", "dimension", "key"], false);
(name = ($truth(belt.kind) ? ("" + $str(belt.name) + " (" + $str(belt.kind) + ")") : belt.name));
yield new Input(group, "Belt", name, undefined, undefined, belt.provenance);
yield inputs___named(group, "belt_width", $bound(belt, "width"), origin("width"));
(measured = belt_modulus__format_test($bound(belt, "kind"), $bound(belt, "modulus_test"), $bound(belt, "modulus_loads")));
(remark = ($truth($math.isinf($bound(belt, "modulus"))) ? "" : measured));
yield inputs___named(group, "belt_modulus", $bound(belt, "modulus"), origin("modulus"), remark);
yield inputs___named(group, "axial_stiffness", $bound(belt, "axial_stiffness"), null, "M B");
yield own("Rating of the belt", $bound(belt, "rating"), "force_per_width", "rating");
if ((belt.breaking_strength != null)) {
yield own("Breaking strength", $bound(belt, "breaking_strength"), "force_per_width", "strength");
}
([least, most] = [belt.least_pulley_diameter, belt.largest_wrap_pressure]);
yield own("Minimum drive pulley", least, "length", "least_pulley_diameter");
yield own("Maximum wrap pressure", most, "pressure", "largest_wrap_pressure");
yield own("Momentary tension over rating", $bound(belt, "momentary_factor"), "number", "momentary_factor");
yield inputs___named(group, "belt_speed", $bound(belt, "speed"), origin("speed"));
(shear = belt.in_plane_shear_stiffness);
if ((shear != null)) {
(origin_of = origin("in_plane_shear_stiffness"));
yield inputs___named(group, "in_plane_shear_stiffness", shear, origin_of);
}
(layers = [...$iter($c2d22), "thickness", "cover_shear_modulus", "cord_diameter", "cord_pitch", "mass"]);
for (key of $iter(layers)) {
if (($b.getattr(belt, key) != null)) {
(name = $m.get($map([["thickness", "belt_thickness"], ["mass", "belt_mass"]]), key, key));
yield inputs___named(group, name, $b.getattr(belt, key), origin(key));
}
}
if (($truth(pitch__covered(belt)) && (belt.cover_shear_modulus == null))) {
yield inputs___named(group, "cover_shear_modulus", 1000000.0, $c838e);
}
}
function inputs___named(group, name, value, origin, remark = "") {
let entry;
(entry = term(name));
return new Input(group, $bound(entry, "title"), value, $bound(entry, "dimension"), $bound(entry, "symbol"), origin, remark, name);
}
function belt_modulus__format_test(kind, test, loads) {
let range_text, ratio;

if (!$truth(test)) {
return "static or dynamic: not stated";
}
(range_text = ((loads == null) ? "" : ("" + ", " + $format($mul(100.0, $at(loads, 0)), ("" + "g")) + " to " + $format($mul(100.0, $at(loads, 1)), ("" + "g")) + " % of strength")));
if (($eq(test, "dynamic"))) {
return ("" + "dynamic" + $str(range_text));
}
(ratio = belt_modulus__find_ratio(kind));
return ("" + "static" + $str(range_text) + ": dynamic " + $format(ratio.least, ("" + "g")) + " to " + $format(ratio.most, ("" + "g")) + " times as much");
}
function belt_modulus__find_ratio(kind) {

return $m.get($c8e29, kind, $at($c8e29, "fabric"));
}
function* inputs___pulley(drive, pulley, overrun = null) {
let by_formula, conditions, group, known, lagging, limit, offset, side, title;

(group = ("" + "Pulley " + $str(pulley.name)));
function origin(key) {
return $m.get(pulley.sources, key, $c7015);
}
$sig(origin, ["key"], false);
yield inputs___named(group, "diameter", $bound(pulley, "diameter"), origin("diameter"));
yield inputs___named(group, "wrap_angle", $bound(pulley, "wrap_angle"), origin("wrap_angle"));
([offset, side] = [pitch__pitch_offset($bound(drive, "belt"), $bound(pulley, "side")), ("" + $str(pulley.side) + " side of the belt")]);
if ((offset != null)) {
yield inputs___named(group, "pitch_offset", offset, null, side);
} else {
if ((!$eq(pulley.side, "pulley"))) {
yield new Input(group, "Meets the", side, undefined, undefined, origin("side"));
}
}
if ((pulley.mass != null)) {
yield inputs___named(group, "pulley_mass", $bound(pulley, "mass"), origin("mass"));
}
if ((pulley.overrun != null)) {
yield inputs___named(group, "overrun", $bound(pulley, "overrun"), origin("overrun"));
} else {
(by_formula = inputs___named(group, "overrun", overrun, null, "from the compression of the lagging, 1.25 delta sqrt(delta/R)"));
yield ((overrun != null) ? by_formula : $replaced(by_formula, new Map([["value", "by formula"]])));
}
if (!$truth(pulley.recovery)) {
yield new Input(group, "Recovery of the lagging", "not counted", undefined, undefined, origin("recovery"));
}
(limit = drive.creep_limit_of(pulley));
(known = (($eq(limit, 0.00635)) ? $c7515 : $c7015));
yield inputs___named(group, "creep_limit", limit, $m.get(pulley.sources, "creep_limit", known));
(conditions = (function* () { for (const lagging of $iter($or(pulley.conditions, () => [pulley.lagging]))) { yield lagging.condition; } })());
([lagging, title] = [("" + $str(pulley.lagging.name) + " (" + $str($m.join(", ", conditions)) + ")"), pulley.lagging.title]);
yield new Input(group, "Lagging", lagging, undefined, undefined, origin("lagging"), title);
yield* $iter(inputs___across(pulley, origin));
}
function* inputs___across(pulley, origin) {
let across, dimension, group, key, profile, remark, rows, size, skew, text, title;

([across, group] = [pulley.across, ("" + "Pulley " + $str(pulley.name))]);
if ((across == null)) {
return null;
}
for ([key, profile] of $iter($m.items(across.profiles()))) {
(title = $m.capitalize($m.replace(key, "_", " ")));
(dimension = (($eq(key, "entry_profile")) ? "force_per_width" : "length"));
(rows = ("" + "maximum less minimum of " + $str($b.len($bound(profile, "position"))) + " places"));
(size = ($truth(profile.value) ? $sub($b.max($bound(profile, "value")), $b.min($bound(profile, "value"))) : profile.crown));
(remark = ($truth(profile.value) ? rows : "crown, on radius"));
yield new Input(group, title, size, dimension, "", origin("across"), remark);
}
if ($truth(across.misalignment)) {
(skew = across.misalignment);
(text = cell__either(("" + $format($mul(1000.0, skew), ("" + ".4g")) + " mm/m"), ("" + $format($mul(12.0, skew), ("" + ".4g")) + " in/ft")));
yield new Input(group, "Misalignment", text, undefined, undefined, origin("across"));
}
if ($truth(across.deflection)) {
yield new Input(group, "Shaft deflection", $bound(across, "deflection"), "length", "", origin("across"));
}
}
function cell__either(si, us) {

return (($eq(si, us)) ? si : ("" + "\u0004" + $str(si) + "\u0005" + $str(us) + "\u0006"));
}
function* inputs__lagging_inputs(lagging, conditions = []) {
let by_law, group, key, least, most, name, scaled, tested;

(group = $add(("" + "Lagging " + $str(lagging.name)), ($truth(conditions) ? ("" + ", " + $str(lagging.condition)) : "")));
(by_law = lagging.source_of("law"));
yield new Input(group, "Friction law", $bound(lagging.law, "title"), undefined, "mu(x, p)", by_law);
if (($in("condition", lagging.sources))) {
(scaled = $at(lagging.notes, $neg(1)));
yield new Input(group, "Scaled to the condition", scaled, undefined, undefined, $at(lagging.sources, "condition"));
}
yield new Input(group, "Slip of the law includes", inputs__in_slip($bound(lagging.law, "slip_includes")), undefined, undefined, by_law);
yield* $iter(inputs___factors(group, lagging));
for ([name, key] of $iter([["lagging_thickness", "thickness"], ["shear_modulus", "shear_modulus"], ["compression_modulus", "compression_modulus"], ["wear_coefficient", "wear_coefficient"]])) {
yield inputs___named(group, name, $b.getattr(lagging, key), lagging.source_of(key));
}
(tested = lagging.law.tested);
if ((tested != null)) {
([least, most] = [tested.pressure_min, tested.pressure_max]);
yield new Input(group, "Tested from a pressure of", least, "pressure", "p", by_law);
yield new Input(group, "Tested to a pressure of", most, "pressure", "p", by_law);
yield new Input(group, "Tested to a slip of", $bound(tested, "slip_max"), "length", "x", by_law);
yield new Input(group, "Tested at a slip speed of", $bound(tested, "slip_speed"), "speed", "", by_law);
}
}
function inputs__in_slip(parts) {

if ((parts == null)) {
return "shear is not stated";
}
return $m.join(" and ", ["sliding", ...$iter(parts)]);
}
function* inputs___factors(group, lagging) {
let name, of, told;

(of = lagging.factors);
if ((of == null)) {
return null;
}
if ((of.by_slip_speed != null)) {
(name = "Friction factor of slip speed, up to");
(told = ("" + "the minimum is " + $format(of.of_slip_speed, ("" + ".3g"))));
yield new Input(group, name, $bound(of, "fastest"), "speed", "", $bound(of.by_slip_speed, "source"), told);
}
if ((of.by_temperature != null)) {
(told = ("" + $format(of.of_temperature, ("" + ".3g"))));
if ((of.temperature == null)) {
(told = ("" + $str(told) + ", the minimum of its table: temperature missing"));
}
(name = "Friction factor of temperature");
yield new Input(group, name, told, undefined, undefined, of.by_temperature.source);
}
}
function* inputs___tensions(drive, arc) {
let group, name, origin, pulley, share, tight, used, value, why;
(pulley = $b.next((function* () { for (const p of $iter(drive.pulleys)) { if (!(($eq(p.name, arc.pulley)))) continue; yield p; } })()));
(group = inputs___arc_group(drive, arc));
(tight = ((arc.entry_tension >= arc.exit_tension) ? "entry_tension" : "exit_tension"));
for (name of $iter(["entry_tension", "exit_tension"])) {
([value, used] = [$b.getattr(arc, name), ""]);
if ((($eq(name, tight)) && (drive.belt.rating != null))) {
(share = cell__percent((value / $mul(drive.belt.rating, drive.belt.width))));
(used = ("" + $str(share) + " of the belt's rating"));
}
(origin = $m.get(pulley.sources, name, $c7015));
(why = inputs___computed(drive, arc, $m.removesuffix(name, "_tension")));
if ($truth(why)) {
([used, origin] = [$m.join("; ", $b.filter(null, [("" + $str($at($cac76, name)) + " " + $str(why)), used])), null]);
}
yield inputs___named(group, name, value, origin, used);
}
}
function inputs___arc_group(drive, arc) {
let several;
(several = ($b.len($bound(drive, "pulleys")) > 1));
return $add(("" + "Load case " + $str(arc.load_case)), ($truth(several) ? ("" + ", pulley " + $str(arc.pulley)) : ""));
}
function inputs___computed(drive, arc, side) {
let cases, found;

(cases = ($truth($b.isinstance(drive, Drive)) ? drive.load_cases : []));
(found = (function* () { for (const c of $iter(cases)) { if (!(($eq(c.name, arc.load_case)))) continue; yield $at(c.tensions, arc.pulley).computed; } })());
return $m.get($b.next(found, $map([])), side, "");
}
function input_tables__input_rows(inputs, of) {

return $b.tuple((function* () { for (const entry of $iter(inputs)) { if (!((entry.value != null))) continue; yield new Row($bound(entry, "title"), [entry.text()], $bound(entry, "symbol"), entry.note(of), $bound(entry, "name")); } })());
}
function errors___stopped(sentence) {
return ((!$truth(sentence) || ($in($at(sentence, $neg(1)), ".?!"))) ? sentence : $add(sentence, "."));
}
function problems___renamed(key, names) {
let name, path, place, position;

(place = []);
(path = []);
for ([name, position] of $iter($m.findall($c2862, key))) {
if ($truth(name)) {
$m.append(path, name);
$m.append(place, $m.get(names, $m.join(".", path), name));
} else {
$m.append(place, $b.int(position));
}
}
return $b.tuple(place);
}
function problems__value_at(raw, place) {
let step;

for (step of $iter(place)) {
if (($truth($b.isinstance(step, "int")) && $truth($b.isinstance(raw, "Sequence")) && (0 < step && step <= $b.len(raw)))) {
(raw = $at(raw, $sub(step, 1)));
} else {
if (($truth($b.isinstance(raw, "Mapping")) && ($in(step, raw)))) {
(raw = $at(raw, step));
} else {
return $ca9ba;
}
}
}
return raw;
}
function lagging_build__build_laggings(record, report) {
let common, found, laws, made, notes, parts, sources;

(found = $b.len($bound(report, "problems")));
(sources = origins__read_sources(record, $c246c, report));
(common = $map([...(function* () { for (const key of $iter($c6dce)) { if (!(($in(key, record)))) continue; yield [key, $at(record, key)]; } })()]));
$put(common, "provenance", $or(origins__own_provenance(record, report), () => new Provenance()));
$put(common, "uncertainty", uncertain__read_uncertainty(record, $c5832, report));
$put(common, "cost", $c5864.built($m.get(record, "cost"), report));
(common = $merged(common, lagging_build___elasticity(record, sources, $at(common, "provenance"), report)));
(laws = [...(function* () { for (const law of $iter($m.get(record, "law", []))) { if (!($truth($b.isinstance(law, Record)))) continue; yield law; } })()]);
(notes = $b.tuple($m.get(record, "notes", [])));
$put(common, "condition_factors", lagging_build___condition_factors(record, report));
(parts = [...(function* () { for (const law of $iter(laws)) { yield lagging_build___law_parts(law, record, sources, notes, report); } })()]);
lagging_build___check_conditions(laws, report);
if ((!$truth($m.get(record, "law")) && $truth(record.sound("law")))) {
report.add([...$iter(record.place), "law"], "missing", "Add a [law] table, as the examples show.");
}
if ((($b.len($bound(report, "problems")) > found) || !$truth(record.sound()))) {
return [];
}
(made = report.tried((() => $b.tuple((function* () { for (const part of $iter(parts)) { yield $call(Lagging, [], [...common, ...part]); } })())), $bound(record, "place"), $bound(record, "raw")));
return $or(made, () => []);
}
function lagging_build___elasticity(record, sources, provenance, report) {
let given, known, message, place, remedy, stated;

(given = [...(function* () { for (const key of $iter($c65ce)) { if (!(($in(key, record)))) continue; yield key; } })()]);
if (!$truth(record.sound("thickness", ...$iter($c65ce)))) {
return $map([]);
}
if ((!$in("thickness", record))) {
if ($truth(given)) {
(place = [...$iter(record.place), "thickness"]);
report.add(place, ("" + "missing: " + $str($at(given, 0)) + " needs it"), "Write thickness = \"12 mm\".");
}
return $map([]);
}
if ((($in("compression_modulus", record)) && ($in("block", record)))) {
(message = "contradicts compression_modulus");
report.add([...$iter(record.place), "block"], message, "Remove one of them.");
return $map([]);
}
(known = $or(($in("elastic_modulus", record)), () => ($in("shear_modulus", record))));
if ((!$truth(known) && ($at(record, "thickness") > 0.0))) {
(place = [...$iter(record.place), "shear_modulus"]);
(remedy = "Give shear_modulus or elastic_modulus.");
report.add(place, "missing for a lagging with thickness", remedy);
return $map([]);
}
(stated = $map([...(function* () { for (const key of $iter($c9095)) { if (!(($in(key, record)))) continue; yield [key, $at(record, key)]; } })()]));
return ($truth(known) ? $merged(stated, lagging_build___estimated(record, sources, provenance, report)) : stated);
}
function lagging_build___estimated(record, sources, provenance, report) {
let basis, block, contact, height, least, message, moduli, of, remedy, shape, text, young;

(least = $at($cd06c, "height").least);
(shape = $m.get(record, "block", $m.get(record, "replaced_block", $map([]))));
(height = (($in("height", shape)) ? $map([]) : $map([["height", $at(record, "thickness")]])));
if ((($in("block", record)) && $truth(height) && ($at(record, "thickness") < least))) {
(message = ("" + "must be at least " + $str(display__display(least, "length")) + " with blocks"));
(remedy = "Give the thickness, or a lagging without blocks.");
report.add([...$iter(record.place), "thickness"], message, remedy, $m.get(record.raw, "thickness"));
return $map([]);
}
(height = $map([...(function* () { for (const [key, value] of $iter($m.items(height))) { yield [key, $b.max(value, least)]; } })()]));
(block = $method($c52db, "built", [shape, report], [...height]));
(moduli = $map([[(($in("block", record)) ? "block" : "replaced_block"), block]]));
(contact = ((block == null) ? 1.0 : block.contact_fraction));
(moduli = $merged(moduli, lagging_build___shear_modulus(record, contact, sources, provenance)));
if ((!$in("compression_modulus", record))) {
(basis = (($in("elastic_modulus", record)) ? "elastic_modulus" : "shear_modulus"));
(young = $mul($at(record, basis), (($eq(basis, "elastic_modulus")) ? 1.0 : 3.0)));
$put(moduli, "compression_modulus", ($truth(block) ? compression__compression_modulus(young, block) : young));
(text = lagging_build___compression_note(block, (($eq(basis, "elastic_modulus")) ? "E" : "3 G")));
(of = $m.get(sources, (($in("block", sources)) ? "block" : basis), provenance));
$m.setdefault(sources, "compression_modulus", $replaced(of, new Map([["note", ("" + "estimated: " + $str(text))]])));
}
return moduli;
}
function lagging_build___shear_modulus(record, contact, sources, provenance) {
let note, of, own, text;

if ((!$in("shear_modulus", record))) {
(text = "G = E/3, incompressible rubber");
if ((contact < 1.0)) {
(text = $add(text, lagging_build__of_blocks(contact)));
}
(of = $m.get(sources, "elastic_modulus", provenance));
$m.setdefault(sources, "shear_modulus", $replaced(of, new Map([["note", ("" + "estimated: " + $str(text))]])));
return $map([["shear_modulus", $mul(contact, ($at(record, "elastic_modulus") / 3.0))]]);
}
if (($eq(contact, 1.0))) {
return $map([]);
}
(own = $m.get(sources, "shear_modulus"));
(note = lagging_build__shear_note(contact));
if (((own != null) && $truth(own.note))) {
(note = $add(note, ("" + "; " + $str(own.note))));
}
$put(sources, "shear_modulus", $replaced($or(own, () => provenance), new Map([["note", note]])));
return $map([["shear_modulus", $mul(contact, $at(record, "shear_modulus"))]]);
}
function lagging_build__of_blocks(contact) {

return ("" + ", over the gross area times the contact fraction " + $format(contact, ("" + "g")));
}
function lagging_build__shear_note(contact) {

return ("" + "estimated: G of the rubber" + $str(lagging_build__of_blocks(contact)));
}
function compression__compression_modulus(elastic_modulus, block) {
let modulus, square;

(square = ($eq(block.shape, "square")));
(modulus = compression__block_modulus(elastic_modulus, square, $bound(block, "width"), $bound(block, "height"), $bound(block, "stiffening"), $bound(block, "contact_fraction")));
return modulus;
}
function lagging_build___compression_note(block, modulus) {
if ((block == null)) {
return ("" + "E_c = " + $str(modulus) + ", no stiffening by the shape of blocks");
}
return ("" + "E_c from " + $str(modulus) + " and the shape of the blocks, Gent and Lindley (1959), " + $str(block.shape) + ", S = " + $format(block.shape_factor, ("" + ".3g")) + ", k = " + $format(block.stiffening, ("" + "g")) + ", contact fraction " + $format(block.contact_fraction, ("" + "g")));
}
function lagging_build___condition_factors(record, report) {
let found, row, source;
(found = $map([]));
for (row of $iter($m.get(record, "condition_factor", []))) {
if (($truth($b.isinstance(row, Record)) && $truth(row.sound()))) {
(source = origins__read_provenance($at(row, "provenance"), report));
$put(found, $at(row, "condition"), $method($c49a9, "built", [row, report], [["source", source]]));
}
}
return $map([...(function* () { for (const [name, factor] of $iter($m.items(found))) { if (!((factor != null))) continue; yield [name, factor]; } })()]);
}
function lagging_build___law_parts(law, record, sources, notes, report) {
let factors, own, parts, scaled, tested;

([own, scaled] = [origins__own_provenance(law, report), null]);
if ($truth($b.isinstance($m.get(law, "condition_source"), Record))) {
(scaled = origins__read_provenance($at(law, "condition_source"), report));
}
(parts = $map([["law", own], ["condition", scaled]]));
(tested = laws__read_law(law, report));
(factors = ((tested != null) ? lagging_build___factors(tested, law, record, report) : null));
if ((factors != null)) {
(parts = $merged(parts, factors.sources));
}
return $map([["law", ((factors != null) ? factors.used : tested)], ["factors", factors], ["condition", $m.get(law, "condition", "dry")], ["scaled_by", $m.get(law, "condition_factor")], ["fit", $cb4b3.built($m.get(law, "fit"), report)], ["notes", [...$iter(notes), ...$iter($m.get(law, "notes", []))]], ["sources", $merged(sources, $map([...(function* () { for (const [part, of] of $iter($m.items(parts))) { if (!($truth(of))) continue; yield [part, of]; } })()]))]]);
}
function laws__read_law(record, report) {
let error, kind, law, names;

if (!$truth(record.sound())) {
return null;
}
(kind = $at(record, "kind"));
(names = $merged($cf9e0, $map([["pressure", $m.get($c2f5d, kind, "tested_pressure")]])));
try {

if (($eq(kind, "integral-log"))) {
(law = laws___integral_log(record));
} else {
if (($eq(kind, "table"))) {
(law = laws___table(record));
} else {
(law = $method($c4eae, "built", [record, report], [["tested", laws___tested(record)]]));
}
}
if (((law != null) && ($in("slip_includes", record)))) {
(law = $replaced(law, new Map([["slip_includes", $b.tuple($b.fromkeys($at(record, "slip_includes")))]])));
}
return law;
} catch ($error) {
if ($error instanceof InputError) {
error = $error;
report.take(error, $bound(record, "place"), $bound(record, "raw"), names);
return null;
} else throw $error;
}
}
function laws___tested(record, ends = null) {
let missing, pressures, slip, speed, there;

([pressures, slip] = [$m.get(record, "tested_pressure"), $m.get(record, "tested_slip")]);
(speed = $m.get(record, "tested_slip_speed"));
if ((ends != null)) {
if ((pressures != null)) {
throw laws___problem("tested_pressure", "contradicts the ends of knots or pieces", "Leave it out.", $shown($at(record.raw, "tested_pressure")));
}
(pressures = $b.list(ends));
}
if (((slip == null) && (speed != null))) {
throw laws___problem("tested_slip", "missing: tested_slip_speed needs it", "Give both.");
}
if (((slip == null) && ((pressures == null) || (ends != null)))) {
return null;
}
if (((pressures == null) || (slip == null))) {
([missing, there] = ["tested_pressure", "tested_slip"]);
if ((slip == null)) {
([missing, there] = [there, missing]);
}
throw laws___problem(missing, ("" + "missing: " + $str(there) + " needs it"), "Give both or none.");
}
return new TestedRange($at(pressures, 0), $at(pressures, 1), slip, speed);
}
function laws___problem(key, message, remedy = "", value = "") {
return errors__input_error(message, remedy, undefined, key, value);
}
function laws___table(record) {
let problems, rows, slips;
(rows = $at(record, "rows"));
laws___check_order(rows, "rows");
(slips = $b.len($at(record, "slip")));
(problems = [...(function* () { for (const [number, row] of $iter($b.enumerate(rows, $k({start: 1})))) { if (!((!$eq($b.len($at(row, "friction")), slips)))) continue; yield new Problem(("" + $str($b.len($at(row, "friction"))) + " values for " + $str(slips) + " slips"), "Give one for each slip.", undefined, ("" + "rows[" + $str(number) + "].friction")); } })()]);
laws___raise(problems);
return new MeasuredTable(undefined, $b.tuple($at(record, "slip")), $b.tuple((function* () { for (const row of $iter(rows)) { yield $at(row, "pressure"); } })()), $b.tuple((function* () { for (const row of $iter(rows)) { yield $b.tuple($at(row, "friction")); } })()));
}
function laws___check_order(rows, key) {
let problems;

(problems = [...(function* () { for (const [number, [before, row]] of $iter($b.enumerate($b.pairwise(rows), $k({start: 2})))) { if (!(($at(row, "pressure") <= $at(before, "pressure")))) continue; yield new Problem(("" + "must be more than " + $str($shown($at(before.raw, "pressure"))) + " of the row before"), "Sort the rows by pressure.", undefined, ("" + $str(key) + "[" + $str(number) + "].pressure")); } })()]);
laws___raise(problems);
}
function laws___raise(problems) {
let found;
if ($truth((found = $b.list(problems)))) {
throw new InputError(found);
}
}
function laws___integral_log(record) {
let coefficients, found, p, tested;
if (($eq(($in("knots", record)), ($in("pieces", record))))) {
(found = (($in("knots", record)) ? "both knots and pieces" : "neither knots nor pieces"));
throw laws___problem("", ("" + "an integral-log law with " + $str(found)), "Give one of the two.");
}
if (($in("knots", record))) {
(coefficients = laws___knots(record));
} else {
(coefficients = laws___pieces(record));
}
(p = coefficients.pressure);
(tested = laws___tested(record, (($b.len(p) > 1) ? [$at(p, 0), $at(p, $neg(1))] : null)));
return new IntegralLog(undefined, coefficients, tested);
}
function laws___pieces(record) {
let error, more, number, pieces, pressure_unit, problems, row, rows, slip_unit;
(slip_unit = laws___unit(record, "slip_unit", "length", "mm"));
(pressure_unit = laws___unit(record, "pressure_unit", "pressure", "kPa"));
(rows = $at(record, "pieces"));
(problems = [...(function* () { for (const [number, [before, row]] of $iter($b.enumerate($b.pairwise(rows), $k({start: 2})))) { if (!(($b.abs($sub(($at(row, "from") / $at(before, "to")), 1.0)) > 1e-09))) continue; yield new Problem(("" + "must be " + $str($shown($at(before.raw, "to"))) + ", the end of the piece before"), "Leave no gap and no overlap.", undefined, ("" + "pieces[" + $str(number) + "].from")); } })()]);
(pieces = []);
for ([number, row] of $iter($b.enumerate(rows, $k({start: 1})))) {
try {
$m.append(pieces, laws___piece(row, slip_unit, pressure_unit));
} catch ($error) {
if ($error instanceof InputError) {
error = $error;
(problems = $add(problems, [...(function* () { for (const p of $iter(error.problems)) { yield new Problem(p.message, p.remedy, undefined, ("" + "pieces[" + $str(number) + "]." + $str(p.key))); } })()]));
} else throw $error;
}
}
laws___raise(problems);
(more = (($in("continuity", record)) ? $map([["continuity", $at(record, "continuity")]]) : $map([])));
return $call(CoefficientPieces, [], [["pressure", [...$iter((function* () { for (const row of $iter(rows)) { yield $at(row, "from"); } })()), $at($at(rows, $neg(1)), "to")]], ["pieces", $b.tuple(pieces)], ["slip_unit", slip_unit], ...more]);
}
function laws___unit(record, key, dimension, example) {
let error, remedy, unit;
if ((!$in(key, record))) {
(remedy = ("" + "Write " + $str(key) + " = \"" + $str(example) + "\", or the unit of their fit."));
throw laws___problem(key, "missing: A and b need it", remedy);
}
(unit = $at(record, key));
try {
return parse__unit_factor(unit, dimension);
} catch ($error) {
if ($error instanceof InputError) {
error = $error;
(remedy = ("" + "Write for example \"" + $str(example) + "\"."));
throw laws___problem(key, $bound($at(error.problems, 0), "message"), remedy);
} else throw $error;
}
}
function laws___piece(row, slip_unit, pressure_unit) {
let error, factors, key, problems, trends;

(trends = $map([]));
(problems = []);
if ((($in("post_peak_slope", row)) && (!$in("residual_friction", row)))) {
$m.append(problems, laws___useless_slope("residual_friction"));
}
(factors = $map([["A", 1.0], ["b", 1.0], ["post_peak_slope", (1.0 / slip_unit)], ["residual_friction", 1.0]]));
for (key of $iter([...(function* () { for (const key of $iter(factors)) { if (!(($in(key, row)))) continue; yield key; } })()])) {
try {
$put(trends, $m.lower(key), trends__read_trend($at(row, key), pressure_unit, $at(factors, key)));
} catch ($error) {
if ($error instanceof InputError) {
error = $error;
(problems = $add(problems, [...(function* () { for (const p of $iter(error.problems)) { yield new Problem(p.message, p.remedy, undefined, key); } })()]));
} else throw $error;
}
}
laws___raise(problems);
return $call(Piece, [], [...trends]);
}
function laws___useless_slope(key) {
return new Problem("missing: post_peak_slope needs it", "Give the level that friction falls to.", undefined, key);
}
function trends__read_trend(text, pressure_unit = 1.0, factor = 1.0) {
let exponent, single, terms, trend;

(terms = trends___terms(text));
(single = (($eq($b.len(terms), 1)) ? $at(terms, 0) : null));
if (($truth(single) && (single.exponent != null))) {
(trend = trends___scaled_exponent($bound(single, "exponent"), $mul(single.coefficient, $b.Decimal(factor)), text));
} else {
if (($truth(single) && ($eq(single.function, "p")) && (!$in(single.power, [0, 1, 2, 3])))) {
(exponent = new Trend("logarithmic", [0.0, single.power]));
(trend = trends___scaled_exponent(exponent, $mul(single.coefficient, $b.Decimal(factor)), text));
} else {
(trend = trends___sum(terms, text, $b.Decimal(factor)));
}
}
return trends___over_pascal(trend, pressure_unit);
}
function trends___terms(text) {
let match, pattern, position, terms;
(pattern = $once(trends___grammar, $kept_trends___grammar)());
(terms = []);
(position = 0);
while ((position < $b.len(text))) {
(match = $m.match(pattern, text, position));
if (((match == null) || ($eq($m.end(match), position)))) {
throw trends___refused(text, "no equation over the pressure p");
}
if ((!($truth($at(match, "number")) || $truth($at(match, "factor"))) || ($truth(terms) && !$truth($at(match, "sign"))))) {
throw trends___refused(text, "no equation over the pressure p");
}
$m.append(terms, trends___term(match, text));
(position = $m.end(match));
}
if (!$truth(terms)) {
throw trends___refused(text, "empty, where an equation is needed");
}
return terms;
}
function trends___grammar() {

return $cfe34;
}
const $kept_trends___grammar = new Map();
function trends___refused(text, message) {
return errors__input_error(message, "Write a polynomial, logarithm, power or exponential of p.", undefined, undefined, $shown(text));
}
function trends___term(match, text) {
let coefficient, factor, inner, power;
(coefficient = $b.Decimal($or($at(match, "number"), () => "1")));
if (($eq($at(match, "sign"), "-"))) {
(coefficient = $neg(coefficient));
}
(factor = $or($at(match, "factor"), () => ""));
if ($truth($m.startswith(factor, "ln"))) {
return new _Term(coefficient, "ln", $b.float($or($at(match, "log_power"), () => 1)), null);
}
if ($truth($m.startswith(factor, "exp"))) {
(inner = trends___sum(trends___terms($at(match, "exponent")), text, $b.Decimal(1)));
return new _Term(coefficient, "exp", 0.0, inner);
}
(power = ($truth(factor) ? $b.float($or($at(match, "within"), () => $or($at(match, "power"), () => "1"))) : 0.0));
return new _Term(coefficient, "p", power, null);
}
function trends___sum(terms, text, factor) {
let coefficients, count, form, functions, seen, term;

(functions = new Set((function* () { for (const term of $iter(terms)) { if (!($truth(term.power))) continue; yield term.function; } })()));
if ((($b.len(functions) > 1) || ($in("exp", new Set((function* () { for (const term of $iter(terms)) { yield term.function; } })()))))) {
throw trends___refused(text, "mixes kinds of trend lines");
}
(coefficients = $mul([0.0], 4));
(seen = $b.set());
for (term of $iter(terms)) {
if ((!$in(term.power, [0, 1, 2, 3]))) {
throw trends___refused(text, "adds a power of p besides 1, 2 and 3");
}
if (($in(term.power, seen))) {
throw trends___refused(text, "has two terms of the same kind");
}
seen.add($bound(term, "power"));
$put(coefficients, $b.int($bound(term, "power")), trends___finite($mul(term.coefficient, factor), text));
}
(count = $add(1, $b.int($b.max(seen))));
(form = (($eq(functions, new Set(["ln"]))) ? "logarithmic" : "polynomial"));
return new Trend(form, $b.tuple($slice(coefficients, null, count)));
}
function trends___finite(number, text) {
let value;
(value = $b.float(number));
if (!$truth($math.isfinite(value))) {
throw trends___refused(text, "a number that is not finite");
}
return value;
}
function trends___scaled_exponent(exponent, coefficient, text) {
let c, first, form, sign, size;

(size = $b.abs(trends___finite(coefficient, text)));
if (($eq(size, 0.0))) {
throw trends___refused(text, "is 0 everywhere");
}
(c = exponent.coefficients);
(first = $add($at(c, 0), $math.log(size)));
(form = (($eq(exponent.form, "logarithmic")) ? "power" : "exponential"));
(sign = ((coefficient > 0) ? 1 : $neg(1)));
return new Trend(form, [first, ...$iter($slice(c, 1, null))], sign);
}
function trends___over_pascal(trend, unit) {
let c;

(c = trend.coefficients);
if ((!$eq(unit, 1.0))) {
if (($in(trend.form, ["logarithmic", "power"]))) {
(c = trends___shifted(c, $neg($math.log(unit))));
} else {
(c = $b.tuple((function* () { for (const [power, value] of $iter($b.enumerate(c))) { yield (value / $pow(unit, power)); } })()));
}
}
return new Trend(trend.form, c, trend.sign);
}
function trends___shifted(c, shift) {

return $b.tuple((function* () { for (const power of $iter($b.range($b.len(c)))) { yield $math.fsum((function* () { for (const k of $iter($b.range(power, $b.len(c)))) { yield $mul($mul($at(c, k), $math.comb(k, power)), $pow(shift, $sub(k, power))); } })()); } })());
}
function laws___knots(record) {
let key, rows, tail;
for (key of $iter(["slip_unit", "pressure_unit", "continuity"])) {
if (($in(key, record))) {
throw laws___problem(key, "belongs to pieces; each number of knots has its own unit");
}
}
(rows = $at(record, "knots"));
laws___check_order(rows, "knots");
laws___raise((function* () { for (const [number, row] of $iter($b.enumerate(rows, $k({start: 1})))) { if (!((($m.get(row, "post_peak_slope", 0.0) < 0.0) && (!$in("residual_friction", row))))) continue; yield laws___useless_slope(("" + "knots[" + $str(number) + "].residual_friction")); } })());
(tail = $b.any((function* () { for (const row of $iter(rows)) { yield $or(($in("post_peak_slope", row)), () => ($in("residual_friction", row))); } })()));
return new PressureKnots($b.tuple((function* () { for (const row of $iter(rows)) { yield $at(row, "pressure"); } })()), $b.tuple((function* () { for (const row of $iter(rows)) { yield $at(row, "peak_friction"); } })()), $b.tuple((function* () { for (const row of $iter(rows)) { yield $at(row, "peak_slip"); } })()), ($truth(tail) ? $b.tuple((function* () { for (const row of $iter(rows)) { yield $m.get(row, "post_peak_slope", 0.0); } })()) : []), ($truth(tail) ? $b.tuple((function* () { for (const row of $iter(rows)) { yield $m.get(row, "residual_friction", $at(row, "peak_friction")); } })()) : []));
}
function lagging_build___factors(tested, law, record, report) {
let found, key, made, source, table, tables;

(tables = $map([]));
for ([key, table] of $iter([["slip_speed", $cd525], ["temperature", $c50d3]])) {
if (($in(("" + $str(key) + "_factor"), law))) {
(source = origins__read_provenance($m.get($at(law, ("" + $str(key) + "_factor")), "provenance"), report));
(found = $method(table, "built", [$at(law, ("" + $str(key) + "_factor")), report], [["source", source]]));
if ((found == null)) {
return null;
}
$put(tables, ("" + "by_" + $str(key)), found);
}
if (($in(key, record))) {
$put(tables, key, $at(record, key));
}
}
if (!$truth(tables)) {
return null;
}
(made = report.tried((() => $call(Factors, [], [["law", tested], ...tables])), $bound(record, "place"), $bound(record, "raw")));
return made;
}
function lagging_build___check_conditions(laws, report) {
let condition, law, message, place, seen;
(seen = $b.set());
for (law of $iter(laws)) {
(condition = $m.get(law, "condition", "dry"));
if (($in(condition, seen))) {
(message = "a second law for this condition");
(place = [...$iter(law.place), "condition"]);
report.add(place, message, "Give each law its own condition.", condition);
}
seen.add(condition);
}
}
function lagging_file__is_path(text) {

return $or($m.endswith(text, ".toml"), () => $or(($in("/", text)), () => ($in("/", text))));
}
function lagging_file__catalogue_laggings(name) {

return $once(lagging_file___catalogue_laggings, $kept_lagging_file___catalogue_laggings)(name, laggingText(name));
}
function lagging_file___catalogue_laggings(name, text) {
return lagging_file___built($once(lagging_file___catalogue_record, $kept_lagging_file___catalogue_record)(name, text), ("" + "catalogue lagging " + $str(name)));
}
const $kept_lagging_file___catalogue_laggings = new Map();
function lagging_file___catalogue_record(name, text) {
let record;
(record = lagging_file___record(text, ("" + "catalogue lagging " + $str(name))));
if ((!$eq($at(record, "name"), name))) {
throw errors__input_error("is not the name of its file", ("" + "Write name = " + $str($shown(name)) + ", or rename the file."), ("" + "catalogue lagging " + $str(name)), "name", $shown($at(record, "name")));
}
return record;
}
const $kept_lagging_file___catalogue_record = new Map();
function lagging_file___record(text, file) {
return lagging_file___checked_record(parsed(text, file), file);
}
function lagging_file___checked_record(document, file) {
let record, report;

([record, report] = source__read_tables($c904b, document, file));
if ($truth(report.problems)) {
lagging_build__build_laggings(record, report);
report.raise_all();
}
return record;
}
function lagging_file___built(record, file) {
let laggings, report;
(report = new Report(file));
(laggings = lagging_build__build_laggings(record, report));
report.raise_all();
return laggings;
}
function drive_build___at_home(error) {

return new InputError((function* () { for (const problem of $iter(error.problems)) { yield (($truth(problem.key) || $truth(problem.line) || !$truth(problem.file)) ? problem : new Problem(("" + $str(problem.file) + ": " + $str(problem.message)), problem.remedy)); } })());
}
function lagging_file__lagging_record(name_or_path, folder, allow_paths) {
let document, path, text;

if (!$truth(lagging_file__is_path(name_or_path))) {
(text = laggingText(name_or_path));
return [$once(lagging_file___catalogue_record, $kept_lagging_file___catalogue_record)(name_or_path, text), ("" + "catalogue lagging " + $str(name_or_path))];
}
if (!$truth(allow_paths)) {
throw errors__input_error("cannot be a path here", "Write a catalogue name, or add a [lagging.NAME] table.", undefined, undefined, $shown(name_or_path));
}
(path = readText(folder, name_or_path));
(document = parsed(readText(path), path));
file_kinds__refuse_other(document, "lagging", path);
return [lagging_file___checked_record(document, path), path];
}
function file_kinds__refuse_other(document, wanted, file = "") {
let kind;

if (($truth(wanted) && $truth(file_kinds___is(document, $at($c0407, wanted))))) {
return null;
}
for (kind of $iter($m.values($c0407))) {
if ($truth(file_kinds___is(document, kind))) {
throw file_kinds___other(kind, file);
}
}
}
function file_kinds___is(document, kind) {
return $b.any((function* () { for (const key of $iter(kind.keys)) { yield ($in(key, document)); } })());
}
function file_kinds___other(kind, file) {
let message;
(message = ("" + "this is " + $str(kind.words) + ": wraparc " + $str(kind.command) + " FILE"));
return errors__input_error(message, undefined, file);
}
function drive_build___merged_origins(base, given) {
let own, provenance, sources;

(own = $or($m.get(given, "provenance"), () => drive_build___given_instead(given)));
(sources = $map([...(function* () { for (const [key, of] of $iter($m.items($m.get(base, "sources", $map([]))))) { if (!((!$in(key, given)))) continue; yield [key, of]; } })()]));
(sources = $merged(sources, $map([...(function* () { for (const key of $iter(given)) { if (!(($in(key, $c31a8)))) continue; yield [key, own]; } })()])));
(provenance = (($in("provenance", base)) ? $map([["provenance", $at(base, "provenance")]]) : $map([])));
return $map([["sources", $merged(sources, $m.get(given, "sources", $map([])))], ...provenance]);
}
function drive_build___given_instead(given) {
let note;

(note = ("" + "instead of that of " + $str($at(given, "preset"))));
return new Record($map([["kind", "given"], ["note", note]]), $bound(given, "place"), $map([]));
}
function limits__limit_problems(thing, limits) {
let given, key, limit, message, problems, value;

(problems = []);
for ([key, limit] of $iter($m.items(limits))) {
(value = $b.getattr(thing, key));
(message = ((value == null) ? "" : limit.refusal(value)));
if ($truth(message)) {
(given = ($truth(isNumber(value)) ? display__display($b.float(value), $bound(limit, "dimension")) : $shown(value)));
$m.append(problems, new Problem(message, undefined, undefined, key, given));
}
}
return problems;
}
function criteria__is_wet(condition) {

return ($in("wet", $m.split($m.lower(condition))));
}
function conditions__design_ratio(standard, surface, condition, tested = "dry") {
let band, dry, here, high, known, low, note, source, there;

(there = [...(function* () { for (const d of $iter((() => $c9375)())) { if (!((($eq(d.standard, standard)) && ($eq(d.surface, surface))))) continue; yield d; } })()]);
(here = $b.next((function* () { for (const d of $iter(there)) { if (!(($eq(d.condition, condition)))) continue; yield d; } })(), null));
(dry = $b.next((function* () { for (const d of $iter(there)) { if (!(($eq(d.condition, tested)))) continue; yield d; } })(), null));
if (((here == null) || (dry == null))) {
(known = $b.sorted(new Set((function* () { for (const d of $iter((() => $c9375)())) { if (!($truth(d.condition))) continue; yield d.standard; } })())));
throw errors__input_error(("" + "no design values " + $str(tested) + " and " + $str($shown(condition)) + " of surface " + $str($shown(surface))), ("" + "Give a factor, or one of " + $str(errors__format_names(known)) + "."), undefined, ("" + "condition." + $str(condition)), $shown(standard));
}
([low, high] = [($at(here.friction, 0) / $at(dry.friction, 1)), ($at(here.friction, 1) / $at(dry.friction, 0))]);
(band = ((low < high) ? ("" + ", " + $format(low, ("" + ".3g")) + " to " + $format(high, ("" + ".3g"))) : ""));
(note = ("" + $str(surface) + " " + $str(condition) + " " + $str(conditions___ends(here)) + " over " + $str(tested) + " " + $str(conditions___ends(dry)) + ", middle values" + $str(band) + "; a ratio of constant design values applied to the whole law"));
(source = new Provenance("published", $bound(here.provenance, "source"), $bound(here.provenance, "date"), note));
return [($b.sum($bound(here, "friction")) / $b.sum($bound(dry, "friction"))), source];
}
function conditions___ends(design) {
let high, low;
([low, high] = design.friction);
return (($eq(low, high)) ? ("" + $format(low, ("" + "g"))) : ("" + $format(low, ("" + "g")) + "-" + $format(high, ("" + "g"))));
}
function conditions__published_conditions(surface) {
let values;

(values = (function* () { for (const d of $iter((() => $c9375)())) { if (!((($eq(d.surface, surface)) && $truth(d.condition)))) continue; yield d; } })());
return $b.tuple($b.fromkeys((function* () { for (const d of $iter(values)) { yield d.condition; } })()));
}
function criteria__choice_problems(thing, choices) {

return [...(function* () { for (const [key, words] of $iter($m.items(choices))) { if (!((!$in($b.getattr(thing, key), words)))) continue; yield new Problem(("" + "must be one of " + $str($m.join(", ", (function* () { for (const word of $iter(words)) { if (!($truth(word))) continue; yield word; } })()))), undefined, undefined, key, $shown($b.getattr(thing, key))); } })()];
}
function uncertain__uncertainty_problems(values, names) {
let key, message, place, problems, value;

(problems = []);
for ([key, value] of $iter($m.items(values))) {
(place = ("" + $str("uncertainty") + "." + $str(key)));
if ((!$in(key, names))) {
$m.append(problems, new Problem("has no uncertainty", uncertain___remedy(key, names), undefined, place));
} else {
if (!(0.0 <= value && value <= 1.0)) {
(message = "must be a percentage from 0 % to 100 %");
$m.append(problems, new Problem(message, undefined, undefined, place, ("" + $format($mul(100.0, value), ("" + "g")) + " %")));
}
}
}
return problems;
}
function limits__name_problems(key, name) {
let message;

if (($truth($b.isinstance(name, "str")) && $truth($m.strip(name)) && ($b.len(name) <= 60) && $truth($m.isprintable(name)))) {
return [];
}
(message = "must be a printable text of 1 to 60 characters");
return [new Problem(message, undefined, undefined, key, $shown(name))];
}
function flight__place_problems(at, position) {
let end, given, message, on_strand, remedy;

if ((!$in(at, $ce3f2))) {
(message = ("" + "must be one of " + $str($m.join(", ", $ce3f2))));
return [new Problem(message, undefined, undefined, "at", $shown(at))];
}
(on_strand = ($in(at, ["carry", "return"])));
if (($truth(on_strand) && (position == null))) {
(end = (($eq(at, "carry")) ? "tail" : "head"));
(remedy = ("" + "Write position = \"120 m\" from the " + $str(end) + "."));
return [new Problem("missing", remedy, undefined, "position", undefined, undefined, "missing")];
}
if (((position != null) && !$truth(on_strand))) {
(message = ("" + "goes with \"carry\" or \"return\", not " + $str(at)));
(given = display__display(position, "length"));
return [new Problem(message, "Leave it out.", undefined, "position", given)];
}
return [];
}
function belt_mass__is_stated(belt) {

return $and((belt.mass != null), () => !($truth(belt_mass__is_of_layers(belt)) || $truth(belt_mass__is_of_conveyor(belt))));
}
function belt_mass__is_of_layers(belt) {

return $and((belt.mass != null), () => ($in("computed from carcass and covers", belt.source_of("mass").note)));
}
function belt_mass__is_of_conveyor(belt) {

return $and((belt.mass != null), () => ($eq(belt.source_of("mass").note, "belt_mass of [conveyor]")));
}
function belt_mass__with_mass(belt, mass, source = null) {
let sources;

(sources = $map([...(function* () { for (const [key, of] of $iter($m.items(belt.sources))) { if (!((!$eq(key, "mass")))) continue; yield [key, of]; } })()]));
return $replaced(belt, new Map([["mass", mass], ["sources", $merged(sources, ((source == null) ? $map([]) : $map([["mass", source]])))]]));
}
function drive___wrong_pulleys(case_, names) {
let missing, parts, unknown;
([missing, unknown] = [$b.sorted($sub(names, $m.keys(case_.tensions))), $b.sorted($sub($m.keys(case_.tensions), names))]);
(parts = ($truth(missing) ? [("" + "no tensions for " + $str($shown(missing)))] : []));
(parts = $add(parts, ($truth(unknown) ? [("" + "tensions for " + $str($shown(unknown)) + ", which the drive does not have")] : [])));
return new Problem($m.join(" and ", parts), undefined, undefined, ("" + "load_case." + $str(case_.name)));
}
function drive__condition_problems(case_, condition, pulleys) {

return [...(function* () { for (const p of $iter(pulleys)) { if (!(($truth(condition) && (!$in(condition, (function* () { for (const lagging of $iter(p.conditions)) { yield lagging.condition; } })()))))) continue; yield new Problem(("" + "pulley " + $str($shown($bound(p, "name"))) + " has no lagging in this condition"), undefined, undefined, ("" + "load_case." + $str(case_) + ".condition"), $shown(condition)); } })()];
}
function drive__covered_problems(criteria, conditions, pulleys) {
let every, laggings, message, remedy, wet;

(laggings = (function* () { for (const p of $iter(pulleys)) { for (const lagging of $iter([p.lagging, ...$iter(p.conditions)])) { yield lagging; }} })());
(every = [...$iter(conditions), ...$iter((function* () { for (const lagging of $iter(laggings)) { yield lagging.condition; } })())]);
(wet = $b.next($b.filter(criteria__is_wet, every), ""));
if (!($truth(criteria.covered) && $truth(wet))) {
return [];
}
(message = ("" + "contradicts condition " + $str($shown(wet))));
(remedy = "Leave out covered or the condition.");
return [new Problem(message, remedy, undefined, "covered", "true")];
}
function drive__named(what, name, among, of = "the drive") {
let one;

for (one of $iter(among)) {
if (($in(name, [null, one.name]))) {
return one;
}
}
throw errors__no_such(what, name, [...(function* () { for (const one of $iter(among)) { yield one.name; } })()], of);
}
function errors__no_such(what, name, known, of = "the drive") {

return errors__input_error(("" + $str(of) + " has no such " + $str(what)), errors__name_remedy(name, known), undefined, undefined, $shown(name));
}
function drive___pull(case_) {
return $math.fsum((function* () { for (const t of $iter($m.values(case_.tensions))) { yield t.effective; } })());
}
function load_case__heaviest(cases, pull) {
let running;

(running = [...(function* () { for (const case_ of $iter(cases)) { if (!(($eq(case_.kind, "running")))) continue; yield case_; } })()]);
return alike__largest($or(running, () => cases), ((case_) => $b.abs(pull(case_))));
}
function drive__laggings_of(pulleys, conditions) {
let condition, found, lagging, pulley;

(found = $map([]));
for (condition of $iter(conditions)) {
for (pulley of $iter(pulleys)) {
(lagging = pulley.lagging_in(condition));
$m.setdefault(found, [lagging.name, lagging.condition], lagging);
}
}
return $b.tuple($m.values(found));
}
function drive___alike(tensions) {
return ($sub($b.max(tensions), $b.min(tensions)) <= $mul(1e-06, $b.max(tensions)));
}
function train___count_problems(key, values, count) {
let message;
if (($eq($b.len(values), count))) {
return [];
}
(message = ("" + "must have one value for each of the " + $str(count) + " pulleys"));
return [new Problem(message, undefined, undefined, key, ("" + $str($b.len(values)) + " values"))];
}
function train___case_problems(case_, names) {
let count, division, given, message, problems, speeds, where;

([where, count] = [("" + "load_case." + $str(case_.name)), $b.len(names)]);
(problems = []);
if (($truth(case_.runs) && (!$eq($b.len($bound(case_, "runs")), $sub(count, 1))))) {
(message = ("" + "must have one value for each of the " + $str($sub(count, 1)) + " runs between pulleys"));
(given = ("" + $str($b.len($bound(case_, "runs"))) + " values"));
$m.append(problems, new Problem(message, undefined, undefined, ("" + $str(where) + ".run"), given));
} else {
if (!$truth($b.all($b.map($math.isfinite, $bound(case_, "runs"))))) {
$m.append(problems, new Problem("must be finite", undefined, undefined, ("" + $str(where) + ".run")));
}
}
if ($truth(problems)) {
return problems;
}
(division = case_.division);
if ($truth($b.isinstance(division, Shares))) {
return train___share_problems(("" + $str(where) + ".share"), $bound(division, "fractions"), case_, count);
}
if ($truth($b.isinstance(division, Pulls))) {
return train___pull_problems(("" + $str(where) + ".share"), $bound(division, "effective_tensions"), case_, count);
}
if ($truth($b.isinstance(division, Speeds))) {
(speeds = division.rotation_speeds);
(problems = train___count_problems(("" + $str(where) + ".speeds"), speeds, count));
if (!$truth($b.all((function* () { for (const speed of $iter(speeds)) { yield (0.0 < speed && speed < Infinity); } })()))) {
(message = "every speed must be positive and finite");
$m.append(problems, new Problem(message, undefined, undefined, ("" + $str(where) + ".speeds")));
}
return problems;
}
return train___motor_problems(("" + $str(where) + ".motor"), $bound(division, "motors"), names);
}
function train___share_problems(key, fractions, case_, count) {
let given, message, problems, pulls, remedy, total;
(problems = train___count_problems(key, fractions, count));
(total = $math.fsum(fractions));
if ((!$truth(problems) && !($b.abs($sub(total, 1.0)) <= 1e-06))) {
(given = $m.join(", ", (function* () { for (const f of $iter(fractions)) { yield ("" + $format(f, ("" + "g"))); } })()));
(message = ("" + "must sum to 1, not to " + $format(total, ("" + ".6g"))));
(remedy = "Give fractions like 0.5 or 50 %.");
$m.append(problems, new Problem(message, remedy, undefined, key, ("" + "[" + $str(given) + "]")));
}
(pulls = [...(function* () { for (const f of $iter(fractions)) { yield $mul(f, case_.effective_tension); } })()]);
return $or(problems, () => train___slack_problems(key, pulls, case_));
}
function train___slack_problems(key, pulls, case_) {
let low, message, remedy;
(low = $b.min((function* () { for (const pair of $iter(train__tensions_at(case_, pulls))) { yield $b.min(pair); } })()));
if ((low > 0.0)) {
return [];
}
(message = ("" + "leaves a belt tension of " + $str(display__display(low, "force"))));
(remedy = "Give other shares, or raise T2.");
return [new Problem(message, remedy, undefined, key)];
}
function train__tensions_at(case_, pulls) {
let runs;

(runs = [...(function* () { for (const i of $iter($b.range($b.len(pulls)))) { yield case_.run(i); } })()]);
return train__along($bound(case_, "entry_tension"), $bound(case_, "exit_tension"), runs, pulls);
}
function train__along(entry, exit_, runs, pulls) {
let i, now, out, pairs, pull, run;

(pairs = []);
(now = entry);
for ([i, [pull, run]] of $iter($b.enumerate($b.zip(pulls, runs, $k({strict: true}))))) {
(out = (($eq(i, $sub($b.len(pulls), 1))) ? exit_ : $sub(now, pull)));
$m.append(pairs, new Pair(now, out));
(now = $add(out, run));
}
return pairs;
}
function train___pull_problems(key, pulls, case_, count) {
let asked, message, problems, size, total;
(problems = train___count_problems(key, pulls, count));
([total, asked] = [$math.fsum(pulls), case_.effective_tension]);
(size = $b.max($bound(case_, "entry_tension"), $bound(case_, "exit_tension")));
if ((!$truth(problems) && !($b.abs($sub(total, asked)) <= $mul(1e-06, size)))) {
(message = ("" + "the pulleys make " + $str(display__display(total, "force", undefined, 6)) + ", the tensions " + $str(display__display(asked, "force", undefined, 6))));
$m.append(problems, new Problem(message, undefined, undefined, key));
}
return $or(problems, () => train___slack_problems(key, pulls, case_));
}
function train___motor_problems(key, motors, names) {
let by_name, leads, message, motor, name, problems, remedy, value, where;
(problems = train___count_problems(key, motors, $b.len(names)));
if ($truth(problems)) {
return problems;
}
(by_name = $b.dict($b.zip(names, motors, $k({strict: true}))));
for ([name, motor] of $iter($m.items(by_name))) {
if (!$truth($b.isinstance(motor, TorqueFollower))) {
continue;
}
(leads = $m.get(by_name, $bound(motor, "master")));
(where = ("" + $str(key) + "." + $str(name) + ".master"));
if ((leads == null)) {
(remedy = errors__name_remedy($bound(motor, "master"), names));
([value, message] = [$shown($bound(motor, "master")), "no such pulley"]);
$m.append(problems, new Problem(message, remedy, undefined, where, value));
} else {
if ($truth($b.isinstance(leads, TorqueFollower))) {
(message = "must not follow another drive itself");
$m.append(problems, new Problem(message, undefined, undefined, where, $shown($bound(motor, "master"))));
}
}
}
if (($eq($at($b.Counter($b.map($b.type, motors)), TorqueFollower), $b.len(motors)))) {
(message = "every drive follows another one");
$m.append(problems, new Problem(message, undefined, undefined, key));
}
return problems;
}
function train___case_of(drive, case_) {
let pairs, runs;
(pairs = [...(function* () { for (const p of $iter(drive.pulleys)) { yield $at(case_.tensions, p.name); } })()]);
(runs = $b.tuple((function* () { for (const [a, b] of $iter($b.pairwise(pairs))) { yield $sub(b.entry, a.exit); } })()));
return new TrainCase(case_.name, $at(pairs, 0).entry, $at(pairs, $neg(1)).exit, new Pulls($b.tuple((function* () { for (const pair of $iter(pairs)) { yield pair.effective; } })())), ($truth($b.any(runs)) ? runs : []), case_.kind, case_.condition, case_.description);
}
function wrap_arc___speed_at(drive, case_, tension) {
let first;

if ((drive.belt.speed == null)) {
return null;
}
(first = $at(case_.tensions, $at(drive.pulleys, 0).name).entry);
return $mul(drive.belt.speed, pitch__strain_ratio(tension, first, $bound(drive.belt, "axial_stiffness")));
}
function pitch__strain_ratio(tension, reference, stiffness) {

return ($add(1.0, (tension / stiffness)) / $add(1.0, (reference / stiffness)));
}
function pull__growth_in(drive, case_, pulley) {
let index, names, pulls, take_up;

([names, take_up] = [[...(function* () { for (const p of $iter(drive.pulleys)) { yield p.name; } })()], drive.criteria.take_up]);
(pulls = [...(function* () { for (const name of $iter(names)) { yield $at(case_.tensions, name).effective; } })()]);
(index = $m.index(names, $bound(pulley, "name")));
return pull__growth_among(pulls, index, $bound(take_up, "fixed"), take_up.place_among(names));
}
function pull__growth_among(pulls, index, fixed, after) {
let mine, slack, tight;

(mine = $b.abs($at(pulls, index)));
if (($eq(mine, 0.0))) {
return $c6b61;
}
([tight, slack] = pull__rise_among(pulls, index, fixed, after));
return new Growth((tight / mine), (slack / mine));
}
function wrap_arc__of_belt(belt, side, law) {
let counted, cover;

([counted, cover] = [pitch__counts_shear(law, "cover shear"), pitch__cover_compliance(belt, side)]);
return $map([["pitch_offset", pitch__pitch_offset(belt, side)], ["cover_compliance", ((counted === false) ? cover : 0.0)], ["cover_left_out", ((counted == null) ? cover : 0.0)], ["side_of_belt", side], ["belt_thickness", pitch__whole_thickness(belt)], ["centrifugal", pitch__centrifugal_of(belt)]]);
}
function pitch__counts_shear(law, part) {

return ((law.slip_includes == null) ? null : ($in(part, law.slip_includes)));
}
function pitch__cover_compliance(belt, side) {
let cover, modulus;

(cover = pitch__sheared_cover(belt, side));
(modulus = ((belt.cover_shear_modulus == null) ? 1000000.0 : belt.cover_shear_modulus));
return ($truth($math.isnan(cover)) ? 0.0 : (cover / modulus));
}
function pitch__sheared_cover(belt, side) {
let cover, of;

(of = pitch__layers_of(belt));
(cover = pitch__touching_cover(of, ($eq(side, "carry"))));
if (((belt.cord_pitch == null) || $truth($math.isnan(cover)))) {
return cover;
}
return pitch__sheared_thickness(cover, $bound(of, "carcass"), $bound(belt, "cord_pitch"));
}
function pitch__sheared_thickness(cover, diameter, pitch) {
let between, share;

(share = (diameter / pitch));
(between = ($math.log($add(1.0, ($add((1.0 / 3.141592653589793), ($mul(0.65, $pow(share, 2)) / $add(1.0, $mul(3.75, $pow(share, 2))))) / share))) / $mul(2.0, 3.141592653589793)));
return $add(cover, $mul($mul(pitch, between), $sub(1.0, $mul(0.44, $math.exp(($mul($mul($neg(4.0), 3.141592653589793), cover) / pitch))))));
}
function pitch__whole_thickness(belt) {
let total;

(total = ((belt.thickness == null) ? $b.sum(pitch__layers_of(belt)) : belt.thickness));
return ($truth($math.isnan(total)) ? null : total);
}
function numbers__used_of(value, limit, at_most) {

if (($truth($math.isnan(value)) || $truth($math.isnan(limit)) || ($eq(limit, 0.0)))) {
return NaN;
}
if ($truth(at_most)) {
return (value / limit);
}
return ((value > 0.0) ? (limit / value) : Infinity);
}
function numbers__kind_of(name, fails) {

if (($truth(fails) && ($in(name, ["creep", "uneven_creep"])))) {
return $at($c76d1, "gross_slip");
}
return $m.get($c76d1, name, $at($c76d1, "condition"));
}
function numbers__order_of(used, missed, kind) {
let place, share;

if (($truth($math.isnan(used)) && !$truth(missed))) {
return Infinity;
}
(share = ($truth($math.isnan(used)) ? 4000.0 : $b.min(used, 4000.0)));
(place = ($truth(missed) ? $mul(kind, 10000.0) : 0.0));
return $sub(place, $mul($math.floor($add((share / 1e-09), 0.5)), 1e-09));
}
function check__quantity_text(value, dimension, against = NaN, form = "slip apart") {
let shown;

if ($truth($math.isnan(value))) {
return "";
}
if ($truth($math.isinf(value))) {
return cell__quantity(value, dimension);
}
(shown = ($truth($math.isnan(against)) ? "slip" : form));
return cellOf(value, dimension, undefined, shown, against);
}
function cell__format_limit(value, dimension, sense, missed_by = NaN, name = "") {

if (!$truth($math.isfinite(value))) {
return cell__quantity(value, dimension);
}
return cellOf(value, dimension, undefined, sense, missed_by, name);
}
function verdict___order(check) {
return check.order;
}
function verdict__data_line(weak) {
let counts, first, inputs, item, items, kind, listed, more, others, seen, text, words;

(items = []);
(seen = []);
for (kind of $iter($ca735)) {
for (item of $iter(weak)) {
if ((($eq($at(item, 0), kind)) && (!$in($at(item, 2), seen)))) {
$m.append(seen, $at(item, 2));
$m.append(items, item);
}
}
}
if (!$truth(items)) {
return new DataLine([], "All inputs measured or published.");
}
(words = $map([...(function* () { for (const kind of $iter($ca735)) { yield [kind, [...(function* () { for (const [k, _, word] of $iter(items)) { if (!(($eq(k, kind)))) continue; yield word; } })()]]; } })()]));
(listed = [...(function* () { for (const kind of $iter($ca735)) { if (!($truth($at(words, kind)))) continue; yield ("" + $str($m.join(", ", $at(words, kind))) + " " + $str(kind)); } })()]);
(text = $m.join("; ", listed));
(text = ("" + $str($m.upper($slice(text, null, 1))) + $str($slice(text, 1, null)) + "."));
if (($b.len($m.split(text)) > 15)) {
(counts = [...(function* () { for (const kind of $iter($ca735)) { if (!($truth($at(words, kind)))) continue; yield [$b.len($at(words, kind)), kind]; } })()]);
([first, ...others] = counts);
(inputs = (($eq($at(first, 0), 1)) ? "input" : "inputs"));
(more = $m.join("", (function* () { for (const [count, kind] of $iter(others)) { yield ("" + ", " + $str(count) + " " + $str(kind)); } })()));
(text = ("" + $str($at(first, 0)) + " " + $str(inputs) + " " + $str($at(first, 1)) + $str(more) + " (--table inputs)."));
}
return new DataLine($b.tuple(items), text);
}
function simple___is_friction(mu) {
let message;

(message = ("" + "friction must be at least " + $format(1e-06, ("" + "g")) + " and finite"));
return [(1e-06 <= mu && mu < Infinity), "friction_coefficient", ("" + $format(mu, ("" + "g"))), message];
}
function base__check(...tests) {
let failed;

(failed = [...(function* () { for (const [passed, key, value, message] of $iter(tests)) { if (!(!$truth(passed))) continue; yield new Problem(message, undefined, undefined, key, value); } })()]);
if ($truth(failed)) {
throw new InputError(failed);
}
}
function simple___edges(tested) {
return ((tested == null) ? [] : [tested.pressure_min, tested.pressure_max]);
}
function of_train___motor_torque(state) {
return state.motor;
}
function of_arc___binds(drive) {
return drive.criteria.standard.binding;
}
function of_arc___creep_limit(_, state) {
return state.creep_limit;
}
function of_arc___creep(of) {
let limit;

(limit = of.state.creep_limit);
return new CheckText("Creep", "creep", "Creep {value} exceeds the {limit} limit", "Creep {creep} exceeds the {slides} gross-slip limit", undefined, of_arc___allowance($bound(of, "drive"), limit), "creep", (($eq(limit, 0.00635)) ? "conservative limit, 1/4 in; B. DeVries, A model of lagging friction" : "input"), $map([["creep", new Amount($m.get(of.state.found, "exit_creep", NaN), "length")], ["slides", new Amount(0.0635, "length")], ["fabric", new Amount($at($c2c2b, "fabric"), "force_per_width")], ["allowed", new Amount($mul(2.0, 0.00635), "length")]]));
}
function of_arc___allowance(drive, limit) {
let belt, least, over, rating, steel, strong;

(belt = drive.belt);
if ((!$eq(limit, 0.00635))) {
return "";
}
(least = $m.get($c2c2b, $bound(belt, "kind")));
([steel, rating] = [($eq(belt.kind, "steel cord")), belt.rating]);
if (((least == null) || ((rating == null) && !$truth(steel)))) {
return "Unknown whether this belt may creep more: belt.kind or belt.rating missing.";
}
(strong = $or(belt.breaking_strength, () => 0.0));
(over = ($truth(steel) ? (strong > least) : ($or(rating, () => 0.0) > $mul(least, $add(1.0, 1e-09)))));
if ($truth(over)) {
return "DeVries allows {allowed} for this belt (creep_limit).";
}
if (($truth(steel) && !$truth(strong))) {
return "DeVries allows more for steel cord above ST1600; the strength is unknown.";
}
return "This belt does not qualify for more, as steel cord above ST1600 and fabric above {fabric} do (B. DeVries).";
}
function of_drive___tight(state) {
return state.tight;
}
function of_drive___over_width(allowed, state) {
return $mul(allowed, state.width);
}
function of_drive___running(of) {
if ((!$eq(of.case.kind, "running"))) {
return null;
}
return of_drive__tension_text($bound(of.drive, "belt"), $bound(of.case, "kind"), $bound(of.state, "tight"));
}
function of_drive__tension_text(belt, kind, tension) {
let action, factor, momentary, needed, noun, rated, times, title;

([momentary, noun] = [(!$eq(kind, "running")), "belt tension"]);
(title = ($truth(momentary) ? "Belt tension, momentary" : "Belt tension, running"));
if ((belt.rating == null)) {
return new CheckText(title, noun, undefined, undefined, undefined, undefined, undefined, undefined, undefined, "belt.rating");
}
(factor = of_drive__tension_factor(belt, kind));
(times = ((!$eq(factor, 1.0)) ? ("" + " times " + $format(factor, ("" + "g"))) : ""));
(rated = $mul(belt.rating, belt.width));
(action = "Use a belt rated {rated} (now {rating}).");
if (($truth(momentary) && (belt.momentary_factor == null))) {
(action = "Use a belt rated {rated}, or give momentary_factor {factor} if its maker allows it.");
}
(needed = (tension / $mul(belt.width, factor)));
return new CheckText(title, noun, $add("Belt tension {value} exceeds the {limit} ", (($truth(momentary) && (!$eq(factor, 1.0))) ? "momentary rating" : "rating")), undefined, action, ("" + "{share} % of the rating" + $str(($truth(times) ? ("" + ", factor " + $format(factor, ("" + "g"))) : "")) + "."), "belt tension", ("" + "rating of the belt" + $str(times) + ": " + $str(rule__origin($m.get(belt.sources, "rating", $bound(belt, "provenance"))))), $map([["share", new Amount(($mul(100.0, tension) / rated), "number")], ["factor", new Amount((tension / rated), "number", "up")], ["rated", new Amount(needed, "force_per_width", "up")], ["rating", new Amount($bound(belt, "rating"), "force_per_width")]]));
}
function of_drive__tension_factor(belt, kind) {

return (($eq(kind, "running")) ? 1.0 : $or(belt.momentary_factor, () => 1.0));
}
function rule__origin(provenance) {

return $b.str(provenance);
}
function of_drive___momentary(of) {
if (($eq(of.case.kind, "running"))) {
return null;
}
return of_drive__tension_text($bound(of.drive, "belt"), $bound(of.case, "kind"), $bound(of.state, "tight"));
}
function of_drive___rated(drive) {
return of_drive__rated($bound(drive, "belt"));
}
function of_drive__rated(belt) {
let rating, strength;

([strength, rating] = [belt.breaking_strength, belt.rating]);
return $and((strength != null), () => $and((rating != null), () => (strength >= $mul(4.0, rating))));
}
function of_drive___belt_safety(state) {
return ($mul(state.strength, state.width) / state.tight);
}
function of_drive___safety(of) {
let belt, factor, momentary, needed, noun, required, source, title;

([belt, momentary, factor] = [of.drive.belt, (!$eq(of.case.kind, "running")), ""]);
([title, noun] = ["Belt safety factor", "belt safety factor"]);
if ((belt.breaking_strength == null)) {
return new CheckText(title, noun, undefined, undefined, undefined, undefined, undefined, undefined, undefined, "belt.strength");
}
(required = of_drive__required_safety(belt, $bound(of.case, "kind")));
if ($truth($math.isnan(required))) {
return new CheckText(title, noun, undefined, undefined, undefined, undefined, undefined, undefined, undefined, "belt.rating");
}
if (($truth(momentary) && (belt.momentary_factor != null))) {
(factor = ("" + " over momentary_factor, " + $format(belt.momentary_factor, ("" + "g"))));
}
(source = ("" + "customary for " + $str(belt.kind) + ", by works that follow DIN 22101" + $str(factor)));
if ((!$in(belt.kind, $ca5fa))) {
(source = ("" + "the minimum that any belt is rated with" + $str(factor)));
}
if ($truth(of_drive__rated(belt))) {
(source = ("" + "strength over rating of the belt" + $str(factor) + ": " + $str(rule__origin(belt.source_of("rating")))));
}
(needed = ($mul(required, of.state.tight) / belt.width));
return new CheckText(title, noun, "Belt safety factor {value} is below the {limit} minimum", undefined, "Use a belt of strength {strength} or more.", ($truth(of_drive__rated(belt)) ? "The minimum is strength over rating." : "The minimum is customary."), "belt safety factor", source, $map([["strength", new Amount(needed, "force_per_width", "up")]]));
}
function of_drive__required_safety(belt, kind) {
let asked, rating, strength;

([strength, rating] = [belt.breaking_strength, belt.rating]);
if ((strength == null)) {
return NaN;
}
(asked = $m.get($ca5fa, $bound(belt, "kind"), ((rating == null) ? NaN : 4.0)));
if (((rating != null) && $truth(of_drive__rated(belt)))) {
(asked = (strength / rating));
}
(asked = (asked / of_drive__tension_factor(belt, kind)));
return $b.max(asked, 1.0);
}
function of_drive___tight_pressure(state) {
return of_drive__wrap_pressure($bound(state, "tight"), state);
}
function of_drive__wrap_pressure(tension, state) {

return ($mul(2.0, $sub(tension, state.centrifugal)) / $mul(state.width, state.diameter));
}
function of_drive___on_face(of) {
let belt, noun, title;
([belt, title, noun] = [of.drive.belt, "Face pressure", "face pressure"]);
if ((belt.largest_wrap_pressure == null)) {
return new CheckText(title, noun, undefined, undefined, undefined, undefined, undefined, undefined, undefined, "belt.largest_wrap_pressure");
}
return new CheckText(title, noun, "Face pressure {value} exceeds the belt limit {limit}", undefined, "Use pulley diameter {larger} (now {diameter}).", undefined, "face pressure", rule__origin($m.get(belt.sources, "largest_wrap_pressure", $bound(belt, "provenance"))), of_drive___diameter_for(of, $bound(belt, "largest_wrap_pressure")));
}
function of_drive___diameter_for(of, allowed) {
let larger, pressure;

(pressure = of_drive__wrap_pressure($bound(of.state, "tight"), $bound(of, "state")));
(larger = ($mul(of.state.diameter, pressure) / allowed));
return $map([["larger", new Amount(larger, "length", "up")], ["diameter", new Amount($bound(of.state, "diameter"), "length")]]);
}
function of_arc___bond(of) {
return $replaced(of_arc___stress(of, "bond_strength"), new Map([["title", "Bond shear stress"], ["noun", "bond shear stress"], ["label", "bond stress"], ["headline", "Bond shear stress {value} exceeds the strength {limit}"], ["action", "Use a lagging with bond strength {stress} or more."]]));
}
function of_arc___stress(of, key) {
let lagging, stress;

([lagging, stress] = [of.pulley.lagging, $m.get(of.state.found, "peak_shear_stress", NaN)]);
return new CheckText("", undefined, undefined, undefined, undefined, undefined, undefined, rule__origin(lagging.source_of(key)), $map([["stress", new Amount(stress, "pressure", "up")]]), (($b.getattr(lagging, key) == null) ? ("" + "lagging." + $str(key)) : ""));
}
function of_arc___fatigue(of) {
let full, more, pitch, speed, text;
([text, speed, full] = [of_arc___stress(of, "fatigue_limit"), of.drive.belt.speed, ""]);
(more = $b.dict($bound(text, "more")));
if (((speed != null) && (of.result != null))) {
(full = "The belt passes {passes} times an hour.");
(pitch = $add(of.result.arc.radius, of.result.arc.offset));
$put(more, "passes", new Amount(pitch__turns_an_hour(speed, pitch), "number"));
}
return $replaced(text, new Map([["title", "Cyclic shear stress"], ["noun", "cyclic shear stress"], ["label", "fatigue"], ["headline", "Cyclic shear stress {value} exceeds the fatigue limit {limit}"], ["action", "Use a lagging with fatigue limit {stress} or more."], ["full", full], ["more", more]]));
}
function of_drive___tested_max(of) {
let noun, tested, title;
(tested = of.pulley.lagging.law.tested);
([title, noun] = ["Maximum wrap pressure", "maximum wrap pressure"]);
if ((tested == null)) {
return new CheckText(title, "tested wrap pressure", undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, "friction without tests");
}
return new CheckText(title, noun, "Wrap pressure {value} exceeds the tested {limit}", undefined, "Use pulley diameter {larger} (now {diameter}).", "There the friction is extrapolated.", "pressure above tests", of_drive__tests_of($bound(of, "pulley")), of_drive___diameter_for(of, $bound(tested, "pressure_max")));
}
function of_drive__tests_of(pulley) {

return ("" + "tests of lagging " + $str(pulley.lagging.name) + ": " + $str(rule__origin(pulley.lagging.source_of("law"))));
}
function of_drive___slack_pressure(state) {
return of_drive__wrap_pressure($bound(state, "slack"), state);
}
function of_drive___tested_min(of) {
let pressure;
if ((of.pulley.lagging.law.tested == null)) {
return null;
}
(pressure = of_drive__wrap_pressure($bound(of.state, "slack"), $bound(of, "state")));
return new CheckText("Minimum wrap pressure", "minimum wrap pressure", "Wrap pressure {value} is below the tested {limit}", undefined, "Test the lagging at {pressure}.", "There the friction is extrapolated.", "pressure below tests", of_drive__tests_of($bound(of, "pulley")), $map([["pressure", new Amount(pressure, "pressure", "down")]]));
}
function of_arc___slip(of) {
let slip;
if ((of.pulley.lagging.law.tested == null)) {
return null;
}
(slip = $m.get(of.state.found, "largest_slip", NaN));
return new CheckText("Slip, tested range", "slip", "Slip {value} exceeds the tested {limit}", undefined, "Test the lagging to {slip} slip.", "There the friction is extrapolated.", "slip outside tests", of_drive__tests_of($bound(of, "pulley")), $map([["slip", new Amount(slip, "length", "up")]]));
}
function of_arc___speed(of) {
let missing, noun, speed, tested, title;
([tested, title, noun] = [of.pulley.lagging.law.tested, "Slip speed, tested", "slip speed"]);
if ((tested == null)) {
return null;
}
if ((tested.slip_speed == null)) {
(missing = "law.slip_speed");
return new CheckText(title, noun, undefined, undefined, undefined, undefined, undefined, undefined, undefined, missing, undefined, true);
}
(speed = $m.get(of.state.found, "slip_speed", 0.0));
if (((of.drive.belt.speed == null) || $truth($math.isnan(speed)))) {
return new CheckText(title, noun, undefined, undefined, undefined, undefined, undefined, undefined, undefined, "belt.speed");
}
return new CheckText(title, noun, "Slip speed {value} exceeds the tested {limit}", undefined, "Test the lagging at {speed}.", "How the friction changes with slip speed is unknown.", "slip speed outside tests", of_drive__tests_of($bound(of, "pulley")), $map([["speed", new Amount(speed, "speed", "up")]]));
}
function of_drive___slack_end(state) {
return state.slack_end;
}
function of_drive___sag(of) {
let limits, title;

([title, limits] = ["T2 for sag", of.drive.criteria.sag]);
if ($truth($math.isnan($bound(of.state, "slack_end")))) {
return null;
}
if ((limits == null)) {
return new CheckText(title, "sag", undefined, undefined, undefined, undefined, undefined, undefined, undefined, "[sag]");
}
return new CheckText(title, "slack-side tension for sag", ("" + "Slack-side tension {value} is below the {limit} for " + $format($mul(100.0, limits.share), ("" + "g")) + " % sag"), undefined, "Use idler spacing {spacing}.", undefined, "sag", limits.SOURCE, $map([["spacing", new Amount(($mul(limits.spacing, of.state.slack_end) / limits.tension), "length", "down")]]));
}
function of_drive___diameter(state) {
return state.diameter;
}
function of_drive___bending(of) {
let belt, ends, least, noun, pulley, title;

([belt, title, pulley] = [of.drive.belt, "Pulley diameter", of.pulley]);
([noun, least] = ["pulley diameter", belt.least_pulley_diameter]);
(ends = [...(function* () { for (const case_ of $iter(of.drive.load_cases)) { yield $at(case_.tensions, pulley.name); } })()]);
if ((least == null)) {
return new CheckText(title, noun, undefined, undefined, undefined, undefined, undefined, undefined, undefined, "belt.least_pulley_diameter");
}
if ($truth($b.all((function* () { for (const at of $iter(ends)) { yield pull__idles($bound(at, "entry"), $bound(at, "exit")); } })()))) {
return new CheckText(title, noun, undefined, undefined, undefined, undefined, undefined, undefined, undefined, undefined, ("" + $str(pulley.name) + " is not driven"));
}
return new CheckText(title, noun, "Pulley diameter {value} is below the belt minimum {limit}", undefined, "Use pulley diameter {limit} or more.", undefined, "pulley diameter", rule__origin($m.get(belt.sources, "least_pulley_diameter", $bound(belt, "provenance"))));
}
function table___ascending(values) {
return $b.all((function* () { for (const [a, b] of $iter($b.pairwise(values))) { yield (a < b); } })());
}
function trend___exp(power) {

return ((power < 709.0) ? $math.exp(power) : Infinity);
}
function coefficients___list(values, unit = "") {
return $add($m.join(", ", (function* () { for (const v of $iter(values)) { yield ("" + $format(v, ("" + "g"))); } })()), ($truth(unit) ? ("" + " " + $str(unit)) : ""));
}
function coefficients__peak_from_ab(a, b) {
let slip;

(slip = $math.exp($sub((b / a), 1.0)));
return [$mul($neg(a), slip), slip];
}
function factors___outside(key, value, table, dimension) {
let ends, high, low, message, remedy;

if ((value == null)) {
return [];
}
if ((table == null)) {
(message = ("" + "the law has no " + $str(key) + "_factor"));
(remedy = ("" + "Leave it out, or add [law." + $str(key) + "_factor]."));
return [new Problem(message, remedy, undefined, key, display__display(value, dimension))];
}
([low, high] = [(($eq(key, "slip_speed")) ? 0.0 : $at(table.at, 0)), $at(table.at, $neg(1))]);
if ((low <= value && value <= high)) {
return [];
}
(ends = ("" + $str(display__display($at(table.at, 0), dimension)) + " and " + $str(display__display(high, dimension))));
(message = ("" + "must be between " + $str(ends) + ", where its factor is known"));
return [new Problem(message, "Test the lagging there.", undefined, key, display__display(value, dimension))];
}
function tables___kind_of(owner, attribute) {
let kind, rigid, types;

if ((owner == null)) {
throw new $TypeError(("" + $str(attribute) + " has neither a kind nor a class that says it"));
}
if (($in(attribute, $b.getattr(owner, "LIMITS", $map([]))))) {
(kind = tables__limited(owner, attribute));
(rigid = $and((kind.limit != null), () => kind.limit.rigid));
return ($truth(rigid) ? new WordOr("rigid", kind, Infinity) : kind);
}
(types = $map([...(function* () { for (const f of $iter($fields(owner))) { yield [f.name, f.type]; } })()]));
if (($in($at(types, attribute), [$b.bool, "bool"]))) {
return new Flag();
}
throw new $TypeError(("" + $str(owner.__name__) + " does not say what " + $str(attribute) + " may be"));
}
function tables__limited(owner, key) {
let limit;

(limit = $at(owner.LIMITS, key));
return new Quantity($bound(limit, "dimension"), limit);
}
function tables__missing_remedy(entry) {
let kind;

(kind = entry.kind);
if ($truth(entry.example)) {
return ("" + "Write " + $str(entry.example) + ".");
}
if ($truth($b.isinstance(kind, Quantity))) {
return ("" + "Write for example " + $str(entry.key) + " = " + $str($shown(kind.example())) + ".");
}
if ($truth($b.isinstance(kind, Choice))) {
return ("" + "Write " + $str(entry.key) + " = " + $str($shown($at(kind.options, 0))) + " or another word.");
}
return ("" + "Add " + $str(entry.key) + ".");
}
function tables___sound(value) {

if ($truth($b.isinstance(value, Record))) {
return value.sound();
}
if ($truth($b.isinstance(value, "dict"))) {
return $b.all($b.map(tables___sound, $m.values(value)));
}
if ($truth($b.isinstance(value, "list"))) {
return $b.all($b.map(tables___sound, value));
}
return (value !== $ca9ba);
}
function tables___frozen(value) {
return ($truth($b.isinstance(value, "list")) ? $b.tuple($b.map(tables___frozen, value)) : value);
}
function kinds__table_labels(rows) {
let names;

(names = [...(function* () { for (const row of $iter(rows)) { yield ($truth($b.isinstance(row, "dict")) ? $m.get(row, "name") : null); } })()]);
return [...(function* () { for (const [position, name] of $iter($b.enumerate(names, $k({start: 1})))) { yield (($truth($b.isinstance(name, "str")) && $truth($m.strip(name)) && ($eq($m.count(names, name), 1))) ? name : position); } })()];
}
function belt_modulus__measurement_problems(test, loads) {
let message, percent, problems, remedy;

(problems = []);
if ((!$in(test, ["", ...$iter($c3769)]))) {
(message = ("" + "must be one of " + $str(errors__format_names($c3769))));
$m.append(problems, new Problem(message, undefined, undefined, "modulus_test", $shown(test)));
}
if (((loads != null) && !(0.0 <= $at(loads, 0) && $at(loads, 0) < $at(loads, 1) && $at(loads, 1) <= 1.0))) {
(message = "must be the lowest and the highest load, from 0 to 100 % of the strength");
(percent = [...(function* () { for (const load of $iter(loads)) { yield ("" + $format($mul(100.0, load), ("" + "g")) + " %"); } })()]);
(remedy = "Write for example [\"2 %\", \"10 %\"].");
$m.append(problems, new Problem(message, remedy, undefined, "modulus_loads", $shown(percent)));
}
return problems;
}
function tables__need(key, meaning = "", kind = $c843e, more = new Map()) {

return $replaced($call(Entry, [key, meaning, kind], [...more]), new Map([["required", true]]));
}
function description___known(value, other) {
return ((value == null) ? other : value);
}
function resistance__coefficient_at(length) {
let end, found, high, low, start;

(found = ((length < $at($at($c2838, 0), 0)) ? NaN : $at($at($c2838, $neg(1)), 1)));
for ([[start, high], [end, low]] of $iter($b.pairwise($c2838))) {
if ((start <= length && length <= end)) {
return $add(high, ($mul($sub(low, high), $sub(length, start)) / $sub(end, start)));
}
}
return found;
}
function resistance__no_coefficient(length) {
let least;

if (!$truth($math.isnan(resistance__coefficient_at(length)))) {
return [];
}
(least = $at($at($c2838, 0), 0));
return [new Problem(("" + "below " + $format(least, ("" + "g")) + " m, where no coefficient C is tabulated"), "Give secondary_resistance or length_coefficient.", undefined, "length", display__display(length, "length"))];
}
function* fits__flight_misfits(of) {
let case_, flight, i, key, message, names, problem, stated;

if (($b.len($bound(of, "flights")) > 0)) {
yield* $iter(fits___closing(of));
}
for ([i, flight] of $iter($b.enumerate($bound(of, "flights")))) {
for (problem of $iter(flight.misfits())) {
yield $replaced(problem, new Map([["key", ("" + "flight[" + $str($add(i, 1)) + "]." + $str(problem.key))]]));
}
}
(names = [...(function* () { for (const flight of $iter(of.course_flights)) { yield flight.name; } })()]);
yield* $iter(fits___repeated("flight", names));
yield* $iter(fits___repeated("loading", [...(function* () { for (const point of $iter(of.loadings)) { yield point.name; } })()]));
yield* $iter(fits___repeated("load_case", [...(function* () { for (const case_ of $iter(of.cases)) { yield case_.name; } })()]));
yield* $iter(fits___repeated("drive", [...(function* () { for (const drive of $iter(of.drives)) { yield drive.pulley; } })()]));
yield* $iter(fits___loadings(of, names));
for ([i, case_] of $iter($b.enumerate($bound(of, "cases")))) {
yield* $iter(fits___case(of, case_, ("" + "load_case[" + $str($add(i, 1)) + "]"), names));
}
yield* $iter(fits___drives(of));
yield* $iter(fits___locals(of));
for ([key, stated] of $iter([["length_coefficient", (of.length_coefficient != null)], ["secondary_resistance", (of.secondary_resistance != null)]])) {
if (($truth(stated) && $truth(of.itemised))) {
(message = "contradicts [[conveyor.resistance]], which gives them one by one");
yield new Problem(message, "Leave one of them out.", undefined, key);
}
}
}
function* fits___closing(of) {
let given, high, key, long, made, message, remedy, value;

([long, high] = [$b.sum((function* () { for (const f of $iter(of.flights)) { yield f.length; } })()), $b.sum((function* () { for (const f of $iter(of.flights)) { yield f.rise; } })())]);
for ([key, given, made] of $iter([["length", of.length, long], ["lift", of.lift, high]])) {
if (($b.abs($sub(given, made)) > $mul(0.001, of.length))) {
(message = ("" + "the flights make " + $str(display__display(made, "length"))));
(remedy = "Correct a flight, or leave it out.");
(value = display__display(given, "length"));
yield new Problem(message, remedy, undefined, key, value);
}
}
}
function* fits___repeated(key, names) {
let i, name, remedy;
for ([i, name] of $iter($b.enumerate(names))) {
if (($in(name, $slice(names, null, i)))) {
(remedy = "Give each its own name.");
yield new Problem("used twice", remedy, undefined, ("" + $str(key) + "[" + $str($add(i, 1)) + "]"), name);
}
}
}
function* fits___loadings(of, names) {
let i, key, message, point, remedy, value;
for ([i, point] of $iter($b.enumerate($bound(of, "loadings")))) {
(key = ("" + "loading[" + $str($add(i, 1)) + "]"));
if (($truth(point.flight) && (!$in(point.flight, names)))) {
([value, remedy] = [$shown($bound(point, "flight")), errors__name_remedy($bound(point, "flight"), names)]);
(message = "no such flight");
yield new Problem(message, remedy, undefined, ("" + $str(key) + ".flight"), value);
}
yield* $iter(fits___beyond(of, key, $bound(point, "position")));
if (((point.capacity != null) && (of.speed == null))) {
(remedy = "Write speed = \"3 m/s\" in [belt].");
yield new Problem("needs the belt speed", remedy, undefined, ("" + $str(key) + ".capacity"));
}
}
if (($truth(of.itemised) && (of.speed == null))) {
(remedy = "Write speed = \"3 m/s\" in [belt].");
yield new Problem("needs the belt speed", remedy, undefined, "resistance");
}
}
function* fits___beyond(of, key, position) {
let given, message;

if (((position != null) && (position > $mul(of.length, $add(1.0, 1e-09))))) {
(message = ("" + "is on no flight, the conveyor is " + $str(display__display($bound(of, "length"), "length")) + " long"));
(given = display__display(position, "length"));
yield new Problem(message, undefined, undefined, ("" + $str(key) + ".position"), given);
}
}
function* fits___case(of, case_, key, names) {
let keys, kind, known, listed, loads, message, remedy;
if (($in(case_.name, $c695b))) {
(message = "is a load case of every conveyor");
(remedy = "Give it another name.");
yield new Problem(message, remedy, undefined, ("" + $str(key) + ".name"), $shown($bound(case_, "name")));
}
(listed = ($truth($b.isinstance(case_.loaded, "str")) ? [] : case_.loaded));
if (($truth($b.isinstance(case_.loaded, "str")) && (!$in(case_.loaded, $c28af)))) {
(remedy = ("" + "Write one of " + $str(errors__format_names($c28af)) + ", or an array of flights."));
(message = "must say which flights have material");
yield new Problem(message, remedy, undefined, ("" + $str(key) + ".loaded"), $shown($bound(case_, "loaded")));
return null;
}
yield* $iter(fits___unknown(("" + $str(key) + ".loaded"), listed, names));
yield* $iter(fits___unknown(("" + $str(key) + ".factor"), $bound(case_, "factor"), names));
(loads = [...(function* () { for (const flight of $iter(of.course_flights)) { yield case_.factor_of(flight); } })()]);
if (((!$eq(case_.loaded, "none")) && ($b.max(loads) <= 0.0) && $truth($b.all((function* () { for (const name of $iter(listed)) { yield ($in(name, names)); } })())))) {
(message = "loads no flight");
(remedy = "Name flights, or write loaded = \"none\" for the empty belt.");
yield new Problem(message, remedy, undefined, ("" + $str(key) + ".loaded"));
}
for ([kind, keys] of $iter([["starting", "start_time"], ["braking", "stop_time"]])) {
(known = (($eq(kind, "braking")) ? of.stop_time : $or(of.start_time, () => of.start_factor)));
if ((($eq(case_.kind, kind)) && (known == null))) {
(remedy = ("" + "Write " + $str(keys) + " = \"20 s\"."));
(message = ("" + "needs " + $str(keys) + " of [conveyor]"));
yield new Problem(message, remedy, undefined, ("" + $str(key) + ".kind"), kind);
}
}
}
function* fits___unknown(key, given, names) {
let name, remedy;
for (name of $iter(given)) {
if ((!$in(name, names))) {
(remedy = errors__name_remedy(name, names));
yield new Problem("no such flight", remedy, undefined, key, $shown(name));
}
}
}
function* fits___drives(of) {
let along, drive, i, message, pulleys, remedy, shares, turns, value;

for ([i, drive] of $iter($b.enumerate($bound(of, "drives")))) {
yield* $iter(fits___beyond(of, ("" + "drive[" + $str($add(i, 1)) + "]"), $bound(drive, "position")));
}
(pulleys = [...(function* () { for (const drive of $iter(of.drives)) { yield drive.pulley; } })()]);
if (($truth(of.take_up_after) && (!$in(of.take_up_after, pulleys)))) {
(remedy = errors__name_remedy($bound(of, "take_up_after"), pulleys));
(value = $shown($bound(of, "take_up_after")));
yield new Problem("no such pulley", remedy, undefined, "take_up.after", value);
}
if (($truth(of.take_up_after) && (of.take_up_distance > 0.0))) {
(message = "is a second take-up, besides that after a pulley of [take_up]");
(value = display__display($bound(of, "take_up_distance"), "length"));
(remedy = "A belt has one take-up: leave one of them out.");
yield new Problem(message, remedy, undefined, "take_up_distance", value);
}
(along = [...(function* () { for (const drive of $iter(of.drives)) { yield of.along(drive); } })()]);
(turns = $b.sum((function* () { for (const i of $iter($b.range($b.len(along)))) { yield ($at(along, ($add(i, 1) % $b.len(along))) < $sub($at(along, i), $mul(1e-09, of.length))); } })()));
if ((turns > 1)) {
(message = "the pulleys are not in belt order");
(remedy = "List [[pulley]] as the belt meets them: from the tail up, back along the return.");
yield new Problem(message, remedy, undefined, "drive");
}
(shares = [...(function* () { for (const d of $iter(of.drives)) { if (!((d.brake_share != null))) continue; yield d.brake_share; } })()]);
if ((($b.len(shares) > 0) && ($b.abs($sub($b.sum(shares), 1.0)) > 1e-06))) {
(message = ("" + "the brake shares sum to " + $format($b.sum(shares), ("" + ".6g")) + ", not to 1"));
(remedy = "Give fractions like 0.5 or 50 %.");
yield new Problem(message, remedy, undefined, "drive");
}
}
function* fits___locals(of) {
let bends, i, local, message, remedy;
(bends = false);
for ([i, local] of $iter($b.enumerate($bound(of, "locals")))) {
if (!$truth($b.isinstance(local, TiltResistance))) {
yield* $iter(fits___beyond(of, ("" + "resistance[" + $str($add(i, 1)) + "]"), $bound(local, "position")));
}
(bends = $or(bends, () => $b.isinstance(local, PulleyResistance)));
}
if (($truth(bends) && (of.thickness == null))) {
(message = "needs the thickness of the belt");
(remedy = "Write thickness = \"15 mm\" in [belt].");
yield new Problem(message, remedy, undefined, "resistance");
}
}
function course__course_states(conveyor) {
let full;

(full = course__course_state(conveyor, new ConveyorCase("full", "all")));
return [...(function* () { for (const case_ of $iter(course__standard_cases(conveyor))) { yield course__course_state(conveyor, case_, $bound(full, "pull")); } })()];
}
function course__course_state(conveyor, case_, full_pull = 0.0) {
let _, acceleration, change, forces, moved, moving, one, resting, step, steps, tensions;

(steps = loop__belt_steps(conveyor, case_));
(moving = $b.sum((function* () { for (const step of $iter(steps)) { if (!($truth($b.isinstance(step, Segment)))) continue; yield step.moving; } })()));
(tensions = $mul([[conveyor.take_up, conveyor.take_up]], $b.len(steps)));
(acceleration = 0.0);
(forces = []);
for (_ of $iter($b.range(100))) {
(forces = [...(function* () { for (const [step, [before, after]] of $iter($b.zip(steps, tensions, $k({strict: true})))) { yield ($truth($b.isinstance(step, Segment)) ? $map([...step.forces]) : loop__spot_forces(conveyor, case_, step, $mul(0.5, $add(before, after)))); } })()]);
(resting = $math.fsum((function* () { for (const one of $iter(forces)) { yield $math.fsum($m.values(one)); } })()));
(acceleration = course___acceleration(conveyor, case_, resting, full_pull, moving));
for ([step, one] of $iter($b.zip(steps, forces, $k({strict: true})))) {
if ($truth($b.isinstance(step, Segment))) {
$put(one, "inertia", $mul(acceleration, step.moving));
}
}
(moved = course___follow(conveyor, case_, steps, forces));
(change = $b.max((function* () { for (const [new_, old] of $iter($b.zip(moved, tensions, $k({strict: true})))) { yield $b.abs($sub($at(new_, 1), $at(old, 1))); } })()));
(tensions = moved);
if ((change <= $mul(1e-13, $b.max((function* () { for (const [_, after] of $iter(tensions)) { yield $b.abs(after); } })())))) {
break;
}
}
return course___state(conveyor, case_, acceleration, steps, forces, tensions);
}
function loop__belt_steps(conveyor, case_) {
let here, i, ordered, own, place, places, spots, steps, strand;

(spots = loop___spots(conveyor));
(steps = []);
for (strand of $iter($cf0a0)) {
(own = [...(function* () { for (const spot of $iter(spots)) { if (!(($eq(spot.strand, strand)))) continue; yield spot; } })()]);
(places = loop___places(conveyor, own, strand));
for ([i, place] of $iter($b.enumerate(places))) {
(here = [...(function* () { for (const spot of $iter(own)) { if (!(($eq(loop___nearest(places, $bound(spot, "position")), i)))) continue; yield spot; } })()]);
(ordered = $b.sorted(here, $k({key: ((s) => [$told($c7ecb, s, "rank"), s.order])})));
(steps = $add(steps, ordered));
if (($add(i, 1) < $b.len(places))) {
$m.append(steps, loop___segment(conveyor, case_, strand, place, $at(places, $add(i, 1))));
}
}
}
return steps;
}
function loop___spots(conveyor) {
let after, at_tail, drive, i, local, long, name, place, position, pulley, rank, spots, strand;

(long = conveyor.length);
(spots = []);
for ([i, position] of $iter($b.enumerate(conveyor.loading_positions()))) {
(name = ($truth(conveyor.loadings) ? $at(conveyor.loadings, i).name : "loading"));
$m.append(spots, new loop$Spot("carry", position, 3.0, i, "loading", i, name));
}
(after = $neg(1));
for ([i, drive] of $iter($b.enumerate($bound(conveyor, "course_drives")))) {
([strand, position] = loop___where($bound(drive, "at"), $bound(drive, "position"), long));
$m.append(spots, new loop$Spot(strand, position, 1.0, i, "drive", i, $bound(drive, "pulley")));
if (((!$eq(drive.pulley, "")) && ($eq(drive.pulley, conveyor.take_up_after)))) {
(after = i);
$m.append(spots, new loop$Spot(strand, position, 1.0, i, "take-up", 0, "take-up"));
}
}
if ((after < 0)) {
(at_tail = (conveyor.take_up_distance >= $mul(long, $sub(1.0, 1e-09))));
(rank = ($truth(at_tail) ? -1.0 : 2.0));
(place = ["return", conveyor.take_up_distance]);
$m.append(spots, new loop$Spot(...$iter(place), rank, 0, "take-up", 0, "take-up"));
}
for ([i, local] of $iter($b.enumerate($bound(conveyor, "locals")))) {
if ($truth($b.isinstance(local, SkirtResistance))) {
$m.append(spots, new loop$Spot("carry", $bound(local, "position"), 3.0, i, "local", i, "skirts"));
} else {
if (!$truth($b.isinstance(local, TiltResistance))) {
([strand, position] = loop___where($bound(local, "at"), $bound(local, "position"), long));
(pulley = $b.isinstance(local, PulleyResistance));
(rank = ($truth(pulley) ? 0.0 : 3.0));
if ((($eq(local.at, "head")) && !$truth(pulley))) {
([strand, position] = ["return", 0.0]);
}
(name = ($truth(pulley) ? "pulley" : "cleaner"));
if ($truth($b.isinstance(local, PointResistance))) {
(name = "resistance");
}
$m.append(spots, new loop$Spot(strand, position, rank, i, "local", i, name));
}
}
}
return spots;
}
function loop___where(at, position, length) {

if (($eq(at, "head"))) {
return ["carry", length];
}
if (($eq(at, "tail"))) {
return ["return", length];
}
return [at, $or(position, () => 0.0)];
}
function loop___places(conveyor, spots, strand) {
let edges, flights, found, inward, length, lengths, spot;

(flights = conveyor.course_flights);
(inward = (($eq(strand, "carry")) ? $b.list(flights) : $b.list($b.reversed(flights))));
(lengths = [...(function* () { for (const flight of $iter(inward)) { yield flight.length; } })()]);
(edges = [0.0]);
for (length of $iter(lengths)) {
$m.append(edges, $add($at(edges, $neg(1)), length));
}
(found = $b.list(edges));
for (spot of $iter(spots)) {
if (($b.min((function* () { for (const place of $iter(found)) { yield $b.abs($sub(spot.position, place)); } })()) > $mul(1e-09, conveyor.length))) {
$m.append(found, $bound(spot, "position"));
}
}
return $b.sorted(found);
}
function loop___nearest(places, position) {
let distances;
(distances = [...(function* () { for (const place of $iter(places)) { yield $b.abs($sub(place, position)); } })()]);
return $m.index(distances, $b.min(distances));
}
function loop___segment(conveyor, case_, strand, start, end) {
let carried, carries, factor, flight, forces, from_tail, length, lift, material, middle, own, part, rotating, tilt, whole;

([length, whole, carries] = [$sub(end, start), conveyor.length, ($eq(strand, "carry"))]);
(middle = $mul(0.5, $add(start, end)));
(from_tail = ($truth(carries) ? middle : $sub(whole, middle)));
(flight = loop___flight_at(conveyor, from_tail));
(lift = $mul($mul(flight.sine, length), ($truth(carries) ? 1.0 : $neg(1.0))));
(material = ($truth(carries) ? loop___material_at(conveyor, case_, from_tail) : 0.0));
(carried = $add(conveyor.belt_mass, material));
(rotating = ($truth(carries) ? conveyor.carry_idler_mass : conveyor.return_idler_mass));
(own = ($truth(carries) ? flight.carry_idler_mass : flight.return_idler_mass));
(rotating = ((own == null) ? rotating : own));
(factor = $or(flight.friction_factor, () => conveyor.friction_factor));
(part = $mul((length / whole), ($truth(carries) ? $sub(1.0, conveyor.return_share) : conveyor.return_share)));
(tilt = $b.sum((function* () { for (const local of $iter(conveyor.locals)) { if (!(($truth($b.isinstance(local, TiltResistance)) && ($eq(local.strand, strand))))) continue; yield local.per_weight(whole); } })()));
(forces = $map([["main", resistance__main_resistance(factor, length, $mul(flight.sine, length), rotating, carried)], ["slope", resistance__slope_resistance(lift, carried)], ["secondary", $mul(part, loop___spread_secondary(conveyor, case_))], ["special", $mul(part, conveyor.special_resistance)], ["tilt", $mul($mul($mul($mul(tilt, carried), 9.80665), flight.cosine), length)]]));
return new Segment(strand, flight, start, length, lift, carried, rotating, forces);
}
function loop___flight_at(conveyor, position) {
let end, flight;

(end = 0.0);
for (flight of $iter(conveyor.course_flights)) {
(end = $add(end, flight.length));
if ((position < $sub(end, $mul(1e-09, conveyor.length)))) {
return flight;
}
}
return $at(conveyor.course_flights, $neg(1));
}
function loop___material_at(conveyor, case_, position) {
let loaded, slack;

(slack = $mul(1e-09, conveyor.length));
(loaded = $b.sum((function* () { for (const [i, start] of $iter($b.enumerate(conveyor.loading_positions()))) { if (!((start <= $add(position, slack)))) continue; yield conveyor.loading_mass(i); } })()));
return $mul(loaded, case_.factor_of(loop___flight_at(conveyor, position)));
}
function resistance__main_resistance(friction_factor, length, lift, rotating, carried) {
let cosine;

(cosine = $math.sqrt($sub(1.0, $pow((lift / length), 2))));
return $mul($mul($mul(friction_factor, length), 9.80665), $add(rotating, $mul(carried, cosine)));
}
function resistance__slope_resistance(lift, carried) {

return $mul($mul(9.80665, lift), carried);
}
function loop___spread_secondary(conveyor, case_) {
let coefficient;

(coefficient = conveyor.coefficient);
if ((coefficient == null)) {
return $or(conveyor.secondary_resistance, () => 0.0);
}
return $mul($sub(coefficient, 1.0), loop___main_total(conveyor, case_));
}
function loop___main_total(conveyor, case_) {
let back, carry, cuts, edges, end, factor, flight, length, lift, loaded, middle, own, start, total;

([total, edges] = [0.0, [0.0]]);
for (flight of $iter(conveyor.course_flights)) {
$m.append(edges, $add($at(edges, $neg(1)), flight.length));
}
(cuts = $b.sorted(new Set([...$iter(edges), ...$iter(conveyor.loading_positions())])));
for ([start, end] of $iter($b.pairwise(cuts))) {
(middle = $mul(0.5, $add(start, end)));
([flight, length] = [loop___flight_at(conveyor, middle), $sub(end, start)]);
(factor = $or(flight.friction_factor, () => conveyor.friction_factor));
(lift = $mul(flight.sine, length));
(own = [flight.carry_idler_mass, flight.return_idler_mass]);
(carry = (($at(own, 0) == null) ? conveyor.carry_idler_mass : $at(own, 0)));
(back = (($at(own, 1) == null) ? conveyor.return_idler_mass : $at(own, 1)));
(loaded = $add(conveyor.belt_mass, loop___material_at(conveyor, case_, middle)));
(total = $add(total, resistance__main_resistance(factor, length, lift, carry, loaded)));
(total = $add(total, resistance__main_resistance(factor, length, lift, back, $bound(conveyor, "belt_mass"))));
}
return total;
}
function loop__spot_forces(conveyor, case_, spot, tension) {
let flow, local, point, wrap;

if (($eq(spot.kind, "loading"))) {
if (!$truth(conveyor.itemised)) {
return $map([]);
}
(flow = $mul(conveyor.loading_mass($bound(spot, "which")), $or(conveyor.speed, () => 0.0)));
(flow = $mul(flow, case_.factor_of(loop___flight_at(conveyor, $bound(spot, "position")))));
(point = ($truth(conveyor.loadings) ? $at(conveyor.loadings, spot.which) : null));
if (((point == null) || ($eq(flow, 0.0)))) {
return $map([]);
}
return $map([["loading", local__loading_force(point, flow, $or(conveyor.speed, () => 0.0))]]);
}
if ((!$eq(spot.kind, "local"))) {
return $map([]);
}
(local = $at(conveyor.locals, spot.which));
if ($truth($b.isinstance(local, PulleyResistance))) {
(wrap = $method(local, "wrap", [tension, $or(conveyor.width, () => 0.0), $or(conveyor.thickness, () => 0.0)], [["steel", conveyor.steel]]));
return $map([["wrap", wrap], ["bearing", local.bearing(tension)]]);
}
if ($truth($b.isinstance(local, CleanerResistance))) {
return $map([["cleaner", local.force]]);
}
if ($truth($b.isinstance(local, PointResistance))) {
return $map([["special", local.force]]);
}
if ($truth($b.isinstance(local, SkirtResistance))) {
return $map([["skirt", local.force(loop___material_at(conveyor, case_, $bound(local, "position")))]]);
}
return $map([]);
}
function local__loading_force(point, flow, speed) {
let force, landing, long, mean, rubbing;

(landing = point.material_speed);
(force = $mul(flow, $sub(speed, landing)));
if (((point.skirt_width == null) || (point.density == null))) {
return force;
}
(long = point.acceleration_length);
if ((long == null)) {
(long = ($b.abs($sub($pow(speed, 2), $pow(landing, 2))) / $mul($mul(2.0, 9.80665), point.belt_friction)));
}
(mean = $mul(0.5, $add(speed, landing)));
(rubbing = ($mul($mul(($mul(flow, flow) / point.density), 9.80665), long) / $pow($mul(mean, point.skirt_width), 2)));
return $add(force, $mul(point.skirt_friction, rubbing));
}
function course___acceleration(conveyor, case_, resting, full_pull, moving) {
let speed;

(speed = conveyor.speed);
if ((($eq(case_.kind, "starting")) && (conveyor.start_factor != null))) {
return ($sub($mul(conveyor.start_factor, full_pull), resting) / moving);
}
if ((($eq(case_.kind, "starting")) && (conveyor.start_time != null) && (speed != null))) {
return (speed / conveyor.start_time);
}
if ((($eq(case_.kind, "braking")) && (conveyor.stop_time != null) && (speed != null))) {
return ($neg(speed) / conveyor.stop_time);
}
return 0.0;
}
function course___follow(conveyor, case_, steps, forces) {
let before, i, k, now, shares, start, step, tensions, total;

(total = $math.fsum((function* () { for (const one of $iter(forces)) { yield $math.fsum($m.values(one)); } })()));
(shares = course__drive_shares(conveyor, $bound(case_, "kind")));
(start = $b.next((function* () { for (const [i, step] of $iter($b.enumerate(steps))) { if (!($truth(loop__is_take_up(step)))) continue; yield i; } })()));
(tensions = $mul([[0.0, 0.0]], $b.len(steps)));
(now = conveyor.take_up);
for (k of $iter($b.range($b.len(steps)))) {
(i = ($add(start, k) % $b.len(steps)));
([step, before] = [$at(steps, i), now]);
(now = $add(before, $math.fsum($m.values($at(forces, i)))));
if (($truth($b.isinstance(step, loop$Spot)) && ($eq(step.kind, "drive")))) {
(now = $sub(now, $mul($at(shares, step.which), total)));
}
$put(tensions, i, [before, now]);
}
return tensions;
}
function course__drive_shares(conveyor, kind) {
let braked;

(braked = [...(function* () { for (const d of $iter(conveyor.course_drives)) { if (!((d.brake_share != null))) continue; yield d.brake_share; } })()]);
if ((($eq(kind, "braking")) && ($b.len(braked) > 0))) {
return [...(function* () { for (const d of $iter(conveyor.course_drives)) { yield $or(d.brake_share, () => 0.0); } })()];
}
return [...(function* () { for (const drive of $iter(conveyor.course_drives)) { yield drive.share; } })()];
}
function loop__is_take_up(step) {

return $and($b.isinstance(step, loop$Spot), () => ($eq(step.kind, "take-up")));
}
function course___state(conveyor, case_, acceleration, steps, forces, tensions) {
let at, back, drive, drives, friction, gravity, i, runs, shares;

(shares = course__drive_shares(conveyor, $bound(case_, "kind")));
(drives = []);
for ([i, drive] of $iter($b.enumerate($bound(conveyor, "course_drives")))) {
(at = $b.next((function* () { for (const [k, s] of $iter($b.enumerate(steps))) { if (!($truth(loop__is_drive(s, i)))) continue; yield k; } })()));
$m.append(drives, new DrivePull($bound(drive, "pulley"), $at(shares, i), $at($at(tensions, at), 0), $at($at(tensions, at), 1)));
}
(back = [...(function* () { for (const [i, step] of $iter($b.enumerate(steps))) { if (!(($eq(step.strand, "return")))) continue; yield i; } })()]);
(runs = [...(function* () { for (const i of $iter(back)) { if (!($truth($b.isinstance($at(steps, i), Segment)))) continue; yield i; } })()]);
(gravity = $math.fsum((function* () { for (const one of $iter(forces)) { yield $m.get(one, "slope", 0.0); } })()));
(friction = $math.fsum((function* () { for (const one of $iter(forces)) { yield $m.get(one, "main", 0.0); } })()));
return new state$State(case_.name, case_.kind, course___resistances(conveyor, steps, forces), $at($at(tensions, $at(runs, 0)), 0), $at($at(tensions, $at(runs, $neg(1))), 1), $at(drives, 0).entry, $at(drives, $neg(1)).exit, acceleration, course___points(steps, tensions), course___stretches(steps, forces, tensions), $b.tuple(drives), new Standstill(gravity, friction));
}
function loop__is_drive(step, index) {

return $and($b.isinstance(step, loop$Spot), () => $and(($eq(step.kind, "drive")), () => ($eq(step.which, index))));
}
function course___resistances(conveyor, steps, forces) {
let found, name, parts, sources;

(sources = $map([...$c98c4, ["main", ("" + $str("DIN 22101:2002-08, 6.2; ISO 5048:1989: f L g (m'R + (m'G + m'L) cos delta)") + ", f = " + $format(conveyor.friction_factor, ("" + "g")) + $str(conveyor.unusual_friction))], ["secondary", "given"]]));
if ((conveyor.coefficient != null)) {
$put(sources, "secondary", ("" + $str("DIN 22101:2002-08, 6.3.3: (C - 1) times the main resistance") + ", C = " + $format(conveyor.coefficient, ("" + ".3g"))));
if ((conveyor.length_coefficient != null)) {
$put(sources, "secondary", $add($at(sources, "secondary"), " (input)"));
}
}
(found = []);
for (name of $iter($c5046)) {
(parts = $map([...(function* () { for (const strand of $iter($cf0a0)) { yield [strand, $math.fsum((function* () { for (const [step, one] of $iter($b.zip(steps, forces, $k({strict: true})))) { if (!(($eq(step.strand, strand)))) continue; yield $m.get(one, name, 0.0); } })())]; } })()]));
if ((($in(name, $cab60)) && ($eq($at(parts, "carry"), 0.0) && $eq(0.0, $at(parts, "return"))))) {
continue;
}
$m.append(found, new Resistance(name, $at(parts, "carry"), $at(parts, "return"), $at(sources, name)));
}
return $b.tuple(found);
}
function course___points(steps, tensions) {
let after, before, last, place, points, step;

(points = []);
(last = ["", ""]);
for ([step, [before, after]] of $iter($b.zip(steps, tensions, $k({strict: true})))) {
if ($truth($b.isinstance(step, loop$Spot))) {
(place = [step.strand, step.position, step.name, step.kind]);
$m.append(points, new BeltPoint(...$iter(place), before, after));
} else {
if ((!$eq([step.strand, step.flight.name], last))) {
(last = [step.strand, step.flight.name]);
(place = [step.strand, step.position, step.flight.name, "flight"]);
$m.append(points, new BeltPoint(...$iter(place), before, before));
}
}
}
return $b.tuple(points);
}
function course___stretches(steps, forces, tensions) {
let driven, following, force, found, i, length, name, own, owner, owners, step, total, weight;

(owners = []);
for ([i, step] of $iter($b.enumerate(steps))) {
if ($truth($b.isinstance(step, Segment))) {
$m.append(owners, [step.flight.name, step.strand]);
continue;
}
(following = $b.next((function* () { for (const s of $iter($slice(steps, i, null))) { if (!($truth($b.isinstance(s, Segment)))) continue; yield s; } })(), null));
if (((following == null) || (!$eq(following.strand, step.strand)))) {
$m.append(owners, [(($eq(step.strand, "carry")) ? "head" : "tail"), step.strand]);
} else {
$m.append(owners, [following.flight.name, step.strand]);
}
}
(found = []);
for (owner of $iter($b.fromkeys(owners))) {
(own = [...(function* () { for (const [i, other] of $iter($b.enumerate(owners))) { if (!(($eq(other, owner)))) continue; yield i; } })()]);
(total = $map([]));
([driven, weight, length] = [0.0, 0.0, 0.0]);
for (i of $iter(own)) {
for ([name, force] of $iter($m.items($at(forces, i)))) {
$put(total, name, $add($m.get(total, name, 0.0), force));
}
(step = $at(steps, i));
if ($truth($b.isinstance(step, Segment))) {
(weight = $add(weight, $mul(step.carried, step.length)));
(length = $add(length, step.length));
} else {
if (($eq(step.kind, "drive"))) {
(driven = $add(driven, $add($sub($at($at(tensions, i), 0), $at($at(tensions, i), 1)), $math.fsum($m.values($at(forces, i))))));
}
}
}
$m.append(found, new Stretch($at(owner, 0), $at(owner, 1), $at($at(tensions, $at(own, 0)), 0), $at($at(tensions, $at(own, $neg(1))), 1), $b.min((function* () { for (const i of $iter(own)) { yield $b.min($at(tensions, i)); } })()), total, driven, ((length > 0.0) ? (weight / length) : 0.0)));
}
return $b.tuple(found);
}
function course__standard_cases(conveyor) {
let cases, rises;

(cases = [new ConveyorCase("full"), new ConveyorCase("empty", "none")]);
(rises = [...(function* () { for (const flight of $iter(conveyor.course_flights)) { yield flight.rise; } })()]);
if (($b.min(rises) < 0.0 && 0.0 < $b.max(rises))) {
$m.append(cases, new ConveyorCase("inclines", "inclines"));
$m.append(cases, new ConveyorCase("declines", "declines"));
}
if (((conveyor.start_factor != null) || (conveyor.start_time != null))) {
$m.append(cases, new ConveyorCase("start", undefined, undefined, "starting"));
}
if ((conveyor.stop_time != null)) {
$m.append(cases, new ConveyorCase("stop", undefined, undefined, "braking"));
}
return [...$iter(cases), ...$iter(conveyor.cases)];
}
function check__keeps(value, limit, at_most = true) {

return numbers__kept(value, limit, at_most);
}
function numbers__kept(value, limit, at_most) {
let within;

if ($truth($math.isnan(value))) {
return false;
}
(within = ($truth(at_most) ? (value <= limit) : (value >= limit)));
return $or(within, () => numbers__same_shown(value, limit));
}
function numbers__same_shown(value, limit) {

if (!($truth($math.isfinite(value)) && $truth($math.isfinite(limit)))) {
return ($eq(value, limit));
}
return ($eq(("" + $format(value, ("" + ".3e"))), ("" + $format(limit, ("" + ".3e")))));
}
function numbers__beyond(value, fails, at_most) {

return ($truth(at_most) ? (value > fails) : (value < fails));
}
function fit___has_no_negative(covariance, rounding) {
let before, given, i, j, lower, rest, row, scale;

(scale = [...(function* () { for (const [i, row] of $iter($b.enumerate(covariance))) { yield $or($math.sqrt($b.abs($at(row, i))), () => 1.0); } })()]);
(lower = []);
for ([i, given] of $iter($b.enumerate(covariance))) {
(row = []);
for (j of $iter($b.range($add(i, 1)))) {
(before = ((j < i) ? $at(lower, j) : row));
(rest = $add(($at(given, j) / $mul($at(scale, i), $at(scale, j))), (($eq(i, j)) ? rounding : 0.0)));
(rest = $sub(rest, $math.fsum((function* () { for (const [a, b] of $iter($b.zip(row, $slice(before, null, j), $k({strict: true})))) { yield $mul(a, b); } })())));
if ((($eq(i, j)) && (rest <= 0.0))) {
return false;
}
$m.append(row, (($eq(i, j)) ? $math.sqrt(rest) : (rest / $at($at(lower, j), j))));
}
$m.append(lower, row);
}
return true;
}
function motors___rpm(speed) {
return ("" + $format(($mul(speed, 30.0) / 3.141592653589793), ("" + ".6g")) + " rpm");
}
function* of_arc___standard(of) {
let assumed, criteria, found, limit, noun, pulley, rule, slack, start, tensions, text, title;

([criteria, pulley] = [of.drive.criteria, of.pulley]);
(found = design_standard__find_requirement($bound(criteria, "standard"), $bound(criteria, "take_up"), $bound(pulley, "lagging"), $bound(pulley, "wrap_angle")));
([tensions, rule] = [$at(of.case.tensions, pulley.name), $c960d.for_drive($bound(of, "drive"))]);
if (((found == null) || $truth(pull__idles($bound(tensions, "entry"), $bound(tensions, "exit"))))) {
return null;
}
([title, noun] = [("" + "T2 by " + $str(found.name)), "T2 by the design standard"]);
if ($truth($math.isnan($bound(found, "wrap_factor")))) {
if (!$truth(criteria.standard.name)) {
yield rule__not_checked($bound(rule, "name"), title, noun, $bound(of, "place"), undefined, found.why_not);
return null;
}
yield new Check(rule.name, title, rule.missed, of.place, undefined, undefined, noun, undefined, undefined, undefined, undefined, undefined, check__escaped(("" + $str(found.name) + " does not apply: " + $str(found.why_not))), check__escaped($bound(found, "remedy")), undefined, "standard not applicable", undefined, undefined, undefined, undefined, rule.binding);
return null;
}
(assumed = (($truth(criteria.standard.name) || (criteria.standard.friction != null)) ? "" : " No standard was chosen: CEMA assumed."));
(start = "");
if (((!$eq(criteria.standard.start_factor, 1.0)) && ($eq(of.case.kind, "running")))) {
(start = ("" + " at " + $format(criteria.standard.start_factor, ("" + "g")) + " times Te"));
}
(slack = ((tensions.entry < tensions.exit) ? "Slack-side tension T1" : "T2"));
(text = new CheckText(title, noun, $add($add($add(check__escaped(("" + $str(slack) + " ")), "{value} "), check__escaped(("" + "is below the " + $str(found.name) + " minimum "))), "{limit}"), undefined, ($truth(assumed) ? "Set design_standard.name." : ""), ("" + $str(check__escaped($bound(found, "how"))) + $str(start) + "." + $str(assumed)), "below standard", found.source));
(limit = of_arc__design_slack(of, $bound(found, "wrap_factor")));
yield rule.compare($bound(of.state, "slack"), limit, $bound(of, "place"), text);
}
function* of_arc___cover_creep(of) {
let found, noun, rule, text, title;

([rule, title, noun] = [$c8a85, "Creep with cover", "creep with cover"]);
if (((of.result == null) || ($eq(of.result.arc.cover_left_out, 0.0)))) {
return null;
}
if ($truth(of.unknown)) {
yield rule__not_checked($bound(rule, "name"), title, noun, $bound(of, "place"), undefined, of.unknown);
return null;
}
(found = of.result.covered_creep);
(text = new CheckText(title, noun, ($truth($math.isfinite(found)) ? "Creep {value} with belt cover shear exceeds the {limit} limit" : "Gross slip with belt cover in series"), undefined, "State the cover of the tested belt ([test_belt]).", ("" + $str("Unknown whether the tested slip includes the shear of the belt cover") + "."), "creep with cover", "shear of the cover of the belt"));
yield rule.compare($b.abs(found), $bound(of.state, "creep_limit"), $bound(of, "place"), text);
}
function* in_page_checks__creep_interval(of) {
let fit;

(fit = ((of.result == null) ? null : of.result.arc.fit));
if (((fit == null) || !$truth(fit.knots))) {
return null;
}
yield new Check("creep_interval", "Creep, 95 % bound", "ATTENTION", of.place, undefined, undefined, "creep, 95 % bound", undefined, undefined, undefined, undefined, undefined, "Creep, 95 % bound, is not computed in this page", "Solve the file with wraparc solve.", undefined, "95 % bound not computed", undefined, undefined, undefined, undefined, false);
}
function* of_wet___wet_creep(of) {
let creep, exceeds, factor, lagging, limit, name, slips, source, text, why;

(factor = of_wet__estimate_factor(of));
if (((of.result == null) || ($eq(factor, 0.0)) || $truth(rule__idle($bound(of.result, "arc"))))) {
return null;
}
([name, lagging] = ["wet_creep", of.pulley.lagging]);
([limit, why] = [of.state.creep_limit, of.unknown]);
if ((!$truth(why) && !$truth(check__keeps($b.abs($bound(of.result, "exit_creep")), limit)))) {
(why = "dry creep exceeds its limit");
}
if ((!$truth(why) && $truth($math.isnan(factor)))) {
(why = ("" + $str(lagging.name) + " has no wet friction"));
}
if ($truth(why)) {
yield rule__not_checked(name, "Wet creep", "wet creep (estimated)", $bound(of, "place"), undefined, why);
return null;
}
(creep = in_page_checks__wet($bound(of, "result"), factor));
(exceeds = "Wet creep {value} (estimated) exceeds the {limit} limit");
(slips = ("" + "Gross slip when wet, with dry friction times " + $format(factor, ("" + ".3g")) + " (estimated)"));
(source = $at(new Condition("wet").factor_of(lagging), 1));
(text = new CheckText("Wet creep", "wet creep (estimated)", ($truth($math.isinf(creep)) ? slips : exceeds), undefined, ("" + "Test lagging " + $str(check__escaped($bound(lagging, "name"))) + " wet."), ("" + "Wet friction " + $format(factor, ("" + ".3g")) + " of dry (" + $str(check__escaped($b.str(source))) + "). A drive that never runs wet has covered = true."), "wet creep", ("" + "creep limit; wet friction " + $format(factor, ("" + ".3g")) + " of dry, " + $str(source))));
yield $c2e75.compare(creep, limit, $bound(of, "place"), text);
}
function in_page_checks__wet(result, _factor) {

return result.found.wet;
}
function of_drive___running_tension(of) {
return (($eq(of.case.kind, "running")) ? of_drive__allowed_tension($bound(of.drive, "belt"), $bound(of.case, "kind")) : null);
}
function of_drive__allowed_tension(belt, kind) {

return ((belt.rating == null) ? null : $mul(of_drive__tension_factor(belt, kind), belt.rating));
}
function of_drive___momentary_tension(of) {
return ((!$eq(of.case.kind, "running")) ? of_drive__allowed_tension($bound(of.drive, "belt"), $bound(of.case, "kind")) : null);
}
function of_drive___required_safety(of) {
return of_drive__required_safety($bound(of.drive, "belt"), $bound(of.case, "kind"));
}
function of_drive___rounded_safety(safety, asked, state) {
let allowed;

(allowed = ($mul(state.strength, state.width) / asked));
return (((safety < asked) && $truth(numbers__same_shown($bound(state, "tight"), allowed))) ? asked : safety);
}
function of_drive___face_pressure(of) {
return of.drive.belt.largest_wrap_pressure;
}
function of_arc___bond_strength(of) {
return of.pulley.lagging.bond_strength;
}
function of_arc___fatigue_limit(of) {
return of.pulley.lagging.fatigue_limit;
}
function of_drive___pressure_max(of) {
let tested;
(tested = of.pulley.lagging.law.tested);
return ((tested == null) ? null : tested.pressure_max);
}
function of_drive___pressure_min(of) {
let tested;
(tested = of.pulley.lagging.law.tested);
return ((tested == null) ? null : tested.pressure_min);
}
function* of_data___condition(of) {
let factor, full, lagging, several, used;

(lagging = of.pulley.lagging);
if (($in("condition", lagging.sources))) {
(factor = lagging.scaled_by);
(used = "dry friction scaled");
if ((factor != null)) {
(several = ($in(" ", lagging.condition)));
(used = ("" + "dry friction times " + $format(factor, ("" + ".3g")) + $str(($truth(several) ? "" : " used"))));
}
(full = ("" + "Source of the factor: " + $str(rule__origin($at(lagging.sources, "condition"))) + "."));
yield of_data___untested(of, $bound(lagging, "condition"), "condition", used, full);
}
if (($in("worn", lagging.sources))) {
yield of_data___untested(of, "worn", "worn", "unworn friction used", "");
}
}
function of_data___untested(of, state, part, used, full) {
let lagging;
(lagging = of.pulley.lagging);
return new Check("condition", ("" + "Friction, " + $str(state)), "ATTENTION", of.place, undefined, undefined, ("" + "friction, " + $str(state)), undefined, undefined, undefined, undefined, undefined, check__escaped(("" + $str(lagging.name) + " not tested " + $str(state) + ": " + $str(used))), ("" + "Test lagging " + $str(check__escaped($bound(lagging, "name"))) + " " + $str(check__escaped(state)) + "."), check__escaped(full), ("" + "not tested " + $str(state)), rule__origin($at(lagging.sources, part)), undefined, undefined, undefined, false);
}
function* of_data___fit(of) {
let first, lagging, more, others;

(lagging = of.pulley.lagging);
if (((lagging.fit == null) || !$truth(lagging.fit.misfit))) {
return null;
}
([first, ...more] = lagging.fit.misfit);
(others = ($truth(more) ? ("" + " (and " + $str($b.len(more)) + " more of its lagging file)") : ""));
yield new Check("fit", "Friction fit", "ATTENTION", of.place, undefined, undefined, "friction fit", undefined, undefined, undefined, undefined, undefined, check__escaped(("" + "Friction law of " + $str(lagging.name) + " deviates from its tests")), "Repeat these tests and refit (wraparc fit).", check__escaped(("" + $str($m.rstrip(first, ".")) + $str(others) + "." + $str(of_data___accepted($bound(lagging.fit, "misfit_accepted"))))), "friction fit", rule__origin($m.get(lagging.sources, "law", $bound(lagging, "provenance"))), undefined, undefined, undefined, false);
}
function of_data___accepted(reason) {
return ($truth(reason) ? ("" + " The laboratory wrote it nevertheless: " + $str($m.rstrip(reason, ".")) + ".") : "");
}
function of_arc___slip_max(of) {
let tested;
(tested = of.pulley.lagging.law.tested);
return ((tested == null) ? null : tested.slip_max);
}
function of_arc___tested_speed(of) {
let tested;
(tested = of.pulley.lagging.law.tested);
return ((tested == null) ? null : tested.slip_speed);
}
function* of_arc___balance(of) {
let arc, error, g, pull, result, text, value;

(result = of.result);
if (((result == null) || $truth(of.unknown) || $truth($math.isnan($bound(result.energy, "identity_error"))))) {
return null;
}
([error, arc] = [result.energy.identity_error, result.arc]);
([pull, g] = [result.effective_tension, result.entry_creep_ratio]);
(value = numbers__balance_miss(error, pull, g, $bound(arc, "entry_tension"), $bound(arc, "compliance")));
(text = new CheckText("Energy balance", "energy balance error", "Energy balance error {value} exceeds {limit}", undefined, "Do not use this result. Report the drive file.", undefined, "internal error", "tolerance of the program"));
yield $c0d6e.compare(value, 0.0001, $bound(of, "place"), text);
}
function numbers__balance_miss(error, pull, g, entry, compliance) {
let exact, scale, told;

(exact = $b.abs($mul(pull, $add(g, $mul($mul(0.5, pull), compliance)))));
(told = $b.max(exact, $mul($mul(1e-06, entry), $b.abs(g)), 1e-300));
(scale = $b.max(exact, $mul($mul(1e-06, entry), $add($b.abs(g), $mul(entry, compliance)))));
return ((scale > 0.0) ? ($mul($b.abs(error), told) / scale) : 0.0);
}
function of_drive___sag_tension(of) {
return ((of.drive.criteria.sag == null) ? null : of.drive.criteria.sag.tension);
}
function of_drive___least_diameter(of) {
return of.drive.belt.least_pulley_diameter;
}
function quantity_text__quantity_text(value, dimension) {
let digits, exact, factor, number, plain, text, unit;

([unit, factor] = display__display_unit(dimension));
(number = (value / factor));
(exact = ($b.Decimal($b.repr(value)) / $b.Decimal($b.repr(factor))));
for (digits of $iter([("" + $format(number, ("" + ".15g"))), ("" + $format(number, ("" + ".16g"))), ("" + $format(number, ("" + ".17g"))), $b.str(exact)])) {
(plain = ("" + $format($b.Decimal(digits), ("" + "f"))));
(text = ("" + $str((($b.len(plain) < 20) ? plain : digits)) + " " + $str(unit)));
if (($eq(parse__parse_quantity(text, dimension), value))) {
return text;
}
}
return ("" + $repr(value) + " " + $str($at($c22c8, dimension).si_unit));
}
function display__display_unit(dimension, system = "si") {
let row;

(row = $once(display__unit_row, $kept_display__unit_row)(dimension, system));
return [row.unit, row.factor];
}
class Problem extends $Object {
__str__() {
const self = this; let fault, place, sentence;
(place = self.file);
if ((self.line != null)) {
(place = ($truth(place) ? ("" + $str(place) + ", line " + $str(self.line)) : ("" + "line " + $str(self.line))));
}
(fault = ($truth(self.value) ? ("" + $str(self.message) + ", got " + $str(self.value)) : self.message));
(sentence = $m.join(": ", (function* () { for (const part of $iter([place, self.key, fault])) { if (!($truth(part))) continue; yield part; } })()));
return $m.join(" ", (function* () { for (const part of $iter([errors___stopped(sentence), errors___stopped($bound(self, "remedy"))])) { if (!($truth(part))) continue; yield part; } })());
}
}
$sig(Problem, ["message", "remedy", "file", "key", "value", "line", "code", "meant"], false, {remedy: () => "", file: () => "", key: () => "", value: () => "", line: () => null, code: () => "", meant: () => ""});
class WraparcError extends $Error {
}
class InputError extends WraparcError {
$init(problems) {
const self = this; (self.problems = ($truth($b.isinstance(problems, Problem)) ? [problems] : $b.tuple(problems)));
if (!$truth(self.problems)) {
throw new $TypeError("InputError needs at least one Problem");
}
super.$init($bound(self, "problems"));
}
__str__() {
const self = this; let lines;
if (($eq($b.len($bound(self, "problems")), 1))) {
return $b.str($at(self.problems, 0));
}
(lines = $m.join("\n", (function* () { for (const problem of $iter(self.problems)) { yield ("" + "  - " + $str(problem)); } })()));
return ("" + $str($b.len($bound(self, "problems"))) + " problems:\n" + $str(lines));
}
}
class Report extends $Object {
$init(file = "") {
const self = this; (self.file = file);
(self.problems = []);
(self._left_out = 0);
}
get full() {
const self = this; 
return ($b.len($bound(self, "problems")) >= 50);
}
add(place, message, remedy = "", value = $ca9ba, code = "", meant = "") {
const self = this; let given, key, problem;

if ($truth(self.full)) {
(self._left_out = $add(self._left_out, 1));
return null;
}
(given = ((value === $ca9ba) ? "" : $shown(value)));
(code = (($eq(message, "missing")) ? "missing" : code));
(key = problems__place_text(place));
(problem = new Problem(message, remedy, undefined, key, given));
self._append($replaced(problem, new Map([["code", code], ["meant", meant]])));
}
take(error, place, raw = $ca9ba, names = null) {
const self = this; let below, given, key, problem, value;

for (problem of $iter(error.problems)) {
if ($truth(problem.file)) {
self._append(problem);
continue;
}
(below = problems___renamed($bound(problem, "key"), $or(names, () => $map([]))));
(given = problems__value_at(raw, below));
(value = ((given === $ca9ba) ? problem.value : $shown(given)));
if ($truth($b.isinstance(given, "list", "dict"))) {
(value = problem.value);
}
(key = problems__place_text($add(place, below)));
self._append($replaced(problem, new Map([["key", key], ["value", value], ["file", self.file]])));
}
}
tried(make, place, raw = $ca9ba, names = null) {
const self = this; let error;

try {
return make();
} catch ($error) {
if ($error instanceof InputError) {
error = $error;
self.take(error, place, raw, names);
return null;
} else throw $error;
}
}
sure(make, place = []) {
const self = this; let made;

(made = self.tried(make, place));
self.raise_all();

return made;
}
_append(problem) {
const self = this; (problem = ($truth(problem.file) ? problem : $replaced(problem, new Map([["file", self.file]]))));
if (($in(problem, self.problems))) {
return null;
}
if (($b.len($bound(self, "problems")) < 50)) {
$m.append(self.problems, problem);
} else {
(self._left_out = $add(self._left_out, 1));
}
}
raise_all() {
const self = this; let message;

if ($truth(self._left_out)) {
(message = ("" + $str(self._left_out) + " more problems are not listed"));
$m.append(self.problems, new Problem(message, undefined, self.file));
}
if ($truth(self.problems)) {
throw new InputError($bound(self, "problems"));
}
}
}
class Record extends $Dict {
$init(values, place, raw, faulty = []) {
const self = this; super.$init(values);
(self.place = place);
(self.raw = raw);
(self.faulty = $b.set(faulty));
}
sound(...keys) {
const self = this; 
return ($truth(keys) ? $m.isdisjoint(self.faulty, keys) : !$truth(self.faulty));
}
}
class Provenance extends $Object {
__post_init__() {
const self = this; if (((self.kind === "published") && !$truth($m.strip(self.source)))) {
throw errors__input_error("a published number without a source", "Name the publication, or call the number given or illustrative.");
}
}
__str__() {
const self = this; let origin, stated;
(origin = $m.join(", ", (function* () { for (const part of $iter([self.source, self.date])) { if (!($truth(part))) continue; yield part; } })()));
(stated = ($truth(origin) ? ("" + $str(self.kind_text) + ": " + $str(origin)) : self.kind_text));
return ($truth(self.note) ? ("" + $str(stated) + " (" + $str(self.note) + ")") : stated);
}
get kind_text() {
const self = this; 
return ((self.kind === "given") ? "input" : $b.str($bound(self, "kind")));
}
}
$sig(Provenance, ["kind", "source", "date", "note"], false, {kind: () => "given", source: () => "", date: () => "", note: () => ""});
class _UnitTextError extends $Error {
$init(message, remedy = "", name = "", meant = []) {
const self = this; super.$init(message);
([self.remedy, self.name, self.meant] = [remedy, name, meant]);
}
}
class Unit extends $Tuple {
}
$sig(Unit, ["factor", "powers", "zero"], false, {zero: () => $ce5b4});
class BeltName extends $Tuple {
get is_steel() {
const self = this; 
return ($eq(self.carcass, "ST"));
}
get standard() {
const self = this; 
if ($truth(self.is_steel)) {
return "ISO 15236, DIN 22131";
}
return (($eq(self.carcass, "PIW")) ? "rated tension in PIW" : "ISO 14890, DIN 22102");
}
}
$sig(BeltName, ["carcass", "strength", "rating", "plies", "carry_cover", "pulley_cover", "grade"], false, {});
class CatalogueBelt extends $Object {
}
$sig(CatalogueBelt, ["name", "kind", "rating", "modulus", "modulus_ends", "strength", "least_pulley_diameter", "pulley_cover", "carry_cover", "carcass", "carcass_ends", "cord_pitch", "carcass_mass", "cover_mass", "modulus_test", "modulus_loads", "permanent_elongation", "provenance", "sources"], false, {modulus_ends: () => null, strength: () => null, least_pulley_diameter: () => null, pulley_cover: () => null, carry_cover: () => null, carcass: () => null, carcass_ends: () => null, cord_pitch: () => null, carcass_mass: () => null, cover_mass: () => null, modulus_test: () => "", modulus_loads: () => null, permanent_elongation: () => null, sources: () => new Map()});
class Laggings extends $Object {
$init(own, folder, allow_paths, report) {
const self = this; (self._report = report);
(self._folder = folder);
(self._allow_paths = allow_paths);
(self._names = $b.tuple(own));
(self._own = $map([]));
(self._built = $map([]));
(self._own = $map([...(function* () { for (const [name, record] of $iter($m.items(own))) { yield [name, ($truth($b.isinstance(record, Record)) ? self._merged(record, name) : null)]; } })()]));
(self._built = $map([...(function* () { for (const [name, record] of $iter($m.items(self._own))) { yield [name, ($truth(record) ? lagging_build__build_laggings(record, report) : [])]; } })()]));
}
of(value, place) {
const self = this; let kept, merged, name, record;

if ($truth($b.isinstance(value, Record))) {
(merged = self._merged(value, ""));
return ($truth(merged) ? lagging_build__build_laggings(merged, $bound(self, "_report")) : []);
}
if (($in(value, self._built))) {
return $at(self._built, $b.str(value));
}
(name = $b.str(value));
(record = self._found(name, place));
if ((record == null)) {
return [];
}
if ($truth(lagging_file__is_path(name))) {
return lagging_build__build_laggings(record, $bound(self, "_report"));
}
(kept = self._report.tried((() => lagging_file__catalogue_laggings(name)), place, name));
return $or(kept, () => []);
}
_found(name, place) {
const self = this; let error, known;

if (($in(name, self._own))) {
return ($truth($at(self._built, name)) ? $at(self._own, name) : null);
}
try {
(known = [...$iter(self._names), ...$iter(laggingNames())]);
if ((!$truth(lagging_file__is_path(name)) && (!$in(name, known)))) {
throw loader__unknown_name("lagging", name, known, "wraparc laggings");
}
return $at(lagging_file__lagging_record(name, $bound(self, "_folder"), $bound(self, "_allow_paths")), 0);
} catch ($error) {
if ($error instanceof InputError) {
error = $error;
self._report.take(drive_build___at_home(error), place, name);
return null;
} else throw $error;
}
}
_merged(given, name) {
const self = this; let base, blocks, group, key, owner, values;

(base = null);
if (($in("preset", given))) {
(base = self._found($at(given, "preset"), [...$iter(given.place), "preset"]));
if ((base == null)) {
return null;
}
}
(values = $b.dict($or(base, () => $map([]))));
for (group of $iter($c3e4a)) {
if ($truth($b.any((function* () { for (const key of $iter(group)) { yield ($in(key, given)); } })()))) {
for (key of $iter(group)) {
$m.pop(values, key, null);
}
}
}
(owner = (($b.len($bound(given, "place")) > 1) ? $b.str($at(given.place, $neg(2))) : "lagging"));
(values = $map([["name", $or(name, () => owner)], ...values, ...given]));
if ((base != null)) {
(values = $merged(values, drive_build___merged_origins(base, given)));
(blocks = $m.get(base, "block", $m.get(base, "replaced_block")));
if ((($in("compression_modulus", given)) && (blocks != null))) {
$put(values, "replaced_block", blocks);
}
}
return new Record(values, $bound(given, "place"), $bound(given, "raw"), $bound(given, "faulty"));
}
}
class Condition extends $Object {
__post_init__() {
const self = this; limits__raise_all($add(limits__limit_problems(self, $bound(self, "LIMITS")), self._wetter()));
}
_wetter() {
const self = this; let factors, message, remedy;

(factors = $map([["factor", self.factor], ...self.factors]));
if (!$truth(criteria__is_wet($bound(self, "name")))) {
return [];
}
([message, remedy] = ["more friction wet than dry", "Give friction wet over dry, such as 0.8."]);
return [...(function* () { for (const [key, factor] of $iter($m.items(factors))) { if (!(((factor != null) && (factor > 1.0)))) continue; yield new Problem(message, remedy, undefined, key, ("" + $format(factor, ("" + "g")))); } })()];
}
lagging(lagging) {
const self = this; let factor, source;

if (($eq(lagging.condition, self.name))) {
return lagging;
}
([factor, source] = self.factor_of(lagging));
return $replaced(lagging, new Map([["law", lagging.law.scaled(factor)], ["condition", self.name], ["sources", $map([...lagging.sources, ["condition", source]])], ["fit", null], ["factors", null], ["scaled_by", factor], ["notes", [...$iter(lagging.notes), self._told(lagging, factor, source)]]]));
}
_told(lagging, factor, source) {
const self = this; let by;

(by = ((source.kind === "published") ? ("" + ", " + $str($at($m.partition(source.source, " and "), 0))) : ""));
return ("" + $str(self.name) + ": friction " + $format(factor, ("" + ".3g")) + " of " + $str(lagging.condition) + $str(by));
}
of(laws) {
const self = this; let tested;

(tested = $b.next((function* () { for (const lagging of $iter(laws)) { if (!(($eq(lagging.condition, self.name)))) continue; yield lagging; } })(), null));
if ((tested != null)) {
return tested;
}
return self.lagging($b.next((function* () { for (const lag of $iter(laws)) { if (!(($eq(lag.condition, "dry")))) continue; yield lag; } })(), $at(laws, 0)));
}
factor_of(lagging) {
const self = this; let own;

(own = $m.get(lagging.condition_factors, $bound(self, "name")));
if ((own != null)) {
return [own.factor, own.source];
}
if (($in(lagging.surface, self.factors))) {
return [$at(self.factors, lagging.surface), self.source];
}
if ($truth(self.standard)) {
return conditions__design_ratio($bound(self, "standard"), $bound(lagging, "surface"), $bound(self, "name"), $bound(lagging, "condition"));
}
if ((self.factor != null)) {
return [self.factor, self.source];
}
if (($eq(self.name, "dry") && $eq("dry", lagging.condition))) {
return [1.0, new Provenance()];
}
return self._published(lagging);
}
_published(lagging) {
const self = this; let standard, tables;

(tables = $b.fromkeys((function* () { for (const d of $iter((() => $c9375)())) { if (!($truth(d.condition))) continue; yield d.standard; } })()));
for (standard of $iter($b.sorted(tables, $k({key: ((name) => (!$eq(name, "DIN 22101")))})))) {
try {
return conditions__design_ratio(standard, $bound(lagging, "surface"), $bound(self, "name"), $bound(lagging, "condition"));
} catch ($error) {
if ($error instanceof InputError) {
continue;
} else throw $error;
}
}
throw new InputError(self._uncovered(lagging));
}
_uncovered(lagging) {
const self = this; let known, more;
(known = conditions__published_conditions($bound(lagging, "surface")));
(more = ($truth(lagging.surface) ? "a law to the lagging" : "surface to the lagging"));
return new Problem(("" + "lagging " + $str($shown($bound(lagging, "name"))) + " has no friction in this condition"), $or(errors__nearest($bound(self, "name"), known), () => ("" + "Give a friction_factor, or add " + $str(more) + ".")), undefined, ("" + "condition." + $str(self.name)));
}
}
$sig(Condition, ["name", "factor", "factors", "standard", "source"], false, {factor: () => null, factors: () => new Map(), standard: () => "", source: () => new Provenance()});
class Conditions extends $Object {
get several() {
const self = this; 
return [...$iter((($b.len($bound(self, "main")) > 1) ? self.main : [])), ...$iter(self.cases)];
}
}
$sig(Conditions, ["main", "cases"], false, {main: () => [], cases: () => []});
class Point extends $Object {
__post_init__() {
const self = this; limits__raise_all(limits__limit_problems(self, $bound(self, "LIMITS")));
}
get side() {
const self = this; 
return $mul((self.diameter / 2.0), (($eq(self.turn, "counterclockwise")) ? 1.0 : $neg(1.0)));
}
}
$sig(Point, ["x", "y", "diameter", "turn"], false, {diameter: () => 0.0, turn: () => "clockwise"});
class UnitRow extends $Tuple {
}
$sig(UnitRow, ["unit", "factor", "larger"], false, {});
class WidthProfile extends $Object {
__post_init__() {
const self = this; let message, numbers, problems, wrong;
(problems = []);
(numbers = [...$iter(self.position), ...$iter(self.value), self.crown]);
if ((!$truth($b.all($b.map($math.isfinite, numbers))) || (!$eq($b.len($bound(self, "position")), $b.len($bound(self, "value")))))) {
(message = "must be pairs of finite numbers, position and value");
$m.append(problems, new Problem(message, undefined, undefined, "rows", $b.str($b.len($bound(self, "position")))));
} else {
if (($eq($b.len($bound(self, "position")), 1))) {
(message = "one row alone makes no profile");
$m.append(problems, new Problem(message, "Give two rows or more.", undefined, "rows"));
}
}
(wrong = [...(function* () { for (const [a, b] of $iter($b.pairwise($bound(self, "position")))) { if (!((b <= a))) continue; yield b; } })()]);
if ($truth(wrong)) {
$m.append(problems, new Problem("the positions must ascend", "Sort the rows by position, the middle of the belt being 0.", undefined, "rows", display__display($at(wrong, 0), "length")));
}
limits__raise_all(problems);
}

get largest() {
const self = this; 
return $add($b.max([...$iter(self.value), 0.0]), $b.max($bound(self, "crown"), 0.0));
}
problems(key, width) {
const self = this; let beyond, edge;

(edge = $mul($mul(0.5, width), $add(1.0, 1e-09)));
(beyond = [...(function* () { for (const y of $iter(self.position)) { if (!(($b.abs(y) > edge))) continue; yield y; } })()]);
if (!$truth(beyond)) {
return [];
}
return [new Problem(("" + "must be between " + $str(display__display($mul($neg(0.5), width), "length")) + " and " + $str(display__display($mul(0.5, width), "length")) + ", the edges"), "Give positions from the middle of the belt.", undefined, key, display__display($at(beyond, 0), "length"))];
}
}
$sig(WidthProfile, ["position", "value", "crown", "uncertainty"], false, {position: () => [], value: () => [], crown: () => 0.0, uncertainty: () => null});
class Criteria extends $Object {
}
$sig(Criteria, ["take_up", "standard", "safety", "sag", "covered"], false, {take_up: () => new TakeUp(), standard: () => new DesignStandard(), safety: () => new SafetyFactors(), sag: () => null, covered: () => false});
class Layers extends $Tuple {
}
$sig(Layers, ["pulley_cover", "carry_cover", "carcass"], false, {});
class Given extends $Object {
static of(name, record, diameter) {
const cls = this; let values;

(values = new LoadGiven(...$iter((function* () { for (const key of $iter($c6fe1)) { yield $m.get(record, key); } })())));
return new cls(name, $bound(record, "place"), values, $bound(record, "raw"), diameter);
}
at(speed) {
const self = this; 
return new DrumAt($bound(self, "diameter"), speed);
}
overridden(record, fixed = false, speed = null, runs = $ca1a4) {
const self = this; let kept, over, own, values;

(over = Given.of($bound(self, "name"), record, $bound(self, "diameter")));
(values = tension_rules__overridden($bound(self, "values"), $bound(over, "values"), fixed, self.at(speed), runs));
(own = $b.zip($c6fe1, values, $bound(self, "values"), $k({strict: true})));
(kept = $b.tuple((function* () { for (const [key, now, before] of $iter(own)) { if (!(((now != null) && (now === before)))) continue; yield key; } })()));
return new Given($bound(self, "name"), $bound(over, "place"), values, $bound(over, "raw"), $bound(self, "diameter"), kept);
}
less_runs(runs, speed) {
const self = this; 
return $replaced(self, new Map([["values", tension_rules__less_runs($bound(self, "values"), runs, self.at(speed))]]));
}
}
$sig(Given, ["name", "place", "values", "raw", "diameter", "inherited"], false, {inherited: () => []});
class NipTensions extends $Tuple {
}
$sig(NipTensions, ["entry", "exit"], false, {});
class Tensions extends $Object {
__post_init__() {
const self = this; limits__raise_all(limits__limit_problems(self, $bound(self, "LIMITS")));
(self.exit = load_case__exit_behind($bound(self, "entry"), $bound(self, "exit")));
}
get effective() {
const self = this; 
return $sub(self.entry, self.exit);
}
get ratio() {
const self = this; 
return (self.entry / self.exit);
}
}
$sig(Tensions, ["entry", "exit", "computed"], false, {computed: () => new Map()});
class LoadCase extends $Object {
__post_init__() {
const self = this; let of, problems;
(problems = criteria__choice_problems(self, $map([["kind", $c93f5]])));
for (of of $iter($m.values(self.uncertainty))) {
(problems = $add(problems, uncertain__uncertainty_problems(of, $c26fe)));
}
limits__raise_all($add(limits__name_problems("name", $bound(self, "name")), problems));
}
}
$sig(LoadCase, ["name", "tensions", "kind", "condition", "description", "uncertainty"], false, {kind: () => "running", condition: () => "", description: () => "", uncertainty: () => new Map()});
class DrivePlace extends $Object {
__post_init__() {
const self = this; limits__raise_all($add(limits__limit_problems(self, $bound(self, "LIMITS")), flight__place_problems($bound(self, "at"), $bound(self, "position"))));
}
}
$sig(DrivePlace, ["pulley", "at", "position", "brake_share", "share"], false, {at: () => "head", position: () => null, brake_share: () => null, share: () => 1.0});
class Viewable extends $Object {


}
class Drive extends Viewable {
__post_init__() {
const self = this; let case_, key, mass, message, names, problems, pulley;
if (((self.conveyor != null) && !$truth(belt_mass__is_stated($bound(self, "belt"))))) {
(mass = self.conveyor.belt_mass);
if ((!$eq(self.belt.mass, mass))) {
(self.belt = belt_mass__with_mass($bound(self, "belt"), mass, $cde36));
}
}
(problems = limits__limit_problems(self, $bound(self, "LIMITS")));
if (!(1 <= $b.len($bound(self, "pulleys")) && $b.len($bound(self, "pulleys")) <= 10)) {
(message = ("" + "a drive needs 1 to " + $str(10) + " pulleys"));
$m.append(problems, new Problem(message, undefined, undefined, "pulley", $b.str($b.len($bound(self, "pulleys")))));
}
(problems = $add(problems, drive__repeated("pulley", (function* () { for (const p of $iter(self.pulleys)) { yield p.name; } })())));
(problems = $add(problems, drive__repeated("load_case", (function* () { for (const c of $iter(self.load_cases)) { yield c.name; } })())));
(problems = $add(problems, self.criteria.take_up.place_problems([...(function* () { for (const p of $iter(self.pulleys)) { yield p.name; } })()])));
(names = new Set((function* () { for (const p of $iter(self.pulleys)) { yield p.name; } })()));
for (case_ of $iter(self.load_cases)) {
if ((!$eq($m.keys(case_.tensions), names))) {
$m.append(problems, drive___wrong_pulleys(case_, names));
}
(problems = $add(problems, drive__condition_problems($bound(case_, "name"), $bound(case_, "condition"), $bound(self, "pulleys"))));
}
(problems = $add(problems, drive__covered_problems($bound(self, "criteria"), $bound(self, "conditions"), $bound(self, "pulleys"))));
(problems = $add(problems, drive__side_problems($bound(self, "belt"), $bound(self, "pulleys"))));
(problems = $add(problems, self._mass_problems()));
for (pulley of $iter(self.pulleys)) {
if ((pulley.across != null)) {
(key = ("" + "pulley." + $str(pulley.name) + ".across"));
(problems = $add(problems, pulley.across.problems(key, $bound(self.belt, "width"))));
}
}
limits__raise_all(problems);
}
_mass_problems() {
const self = this; let key, least, mass, other, problems;

(problems = []);
(mass = self.belt.mass);
if ((mass == null)) {
return problems;
}
if (((self.conveyor != null) && ($b.abs($sub((self.conveyor.belt_mass / mass), 1.0)) > 0.005))) {
(other = display__display($bound(self.conveyor, "belt_mass"), "mass_per_length"));
$m.append(problems, new Problem(("" + "must equal belt_mass " + $str(other) + " of [conveyor]"), "Give one of them, or the same twice.", undefined, "belt.mass", display__display(mass, "mass_per_length")));
}
for ([key, least] of $iter($m.items(drive__least_tensions($bound(self, "load_cases"))))) {
(problems = $add(problems, drive__flying_problems($bound(self, "belt"), key, least)));
}
return problems;
}
pulley(name = null) {
const self = this; 
return drive__named("pulley", name, $bound(self, "pulleys"));
}
load_case(name = null) {
const self = this; 
if ((name == null)) {
return load_case__heaviest($bound(self, "load_cases"), drive___pull);
}
return drive__named("load case", name, $bound(self, "load_cases"));
}
get conditions() {
const self = this; 
return $b.tuple($b.fromkeys((function* () { for (const c of $iter(self.load_cases)) { if (!($truth(c.condition))) continue; yield c.condition; } })()));
}
get laggings() {
const self = this; 
return drive__laggings_of($bound(self, "pulleys"), [...(function* () { for (const case_ of $iter(self.load_cases)) { yield case_.condition; } })()]);
}
in_case(case_) {
const self = this; 
if (!$truth(case_.condition)) {
return self;
}
return $replaced(self, new Map([["pulleys", $b.tuple((function* () { for (const p of $iter(self.pulleys)) { yield p.in_condition($bound(case_, "condition")); } })())]]));
}
slack_end(case_) {
const self = this; let entry, leaving;

([entry, leaving] = self._ends(case_));
return ((drive___pull(case_) >= 0.0) ? leaving : entry);
}
take_up_tension(case_) {
const self = this; let entry, leaving, steady, take_up;

(take_up = self.criteria.take_up);
if ((self.conveyor != null)) {
return self.conveyor.take_up;
}
if ($truth(take_up.fixed)) {
return self.slack_end(self.load_case());
}
if ($truth(take_up.after)) {
return $at(case_.tensions, take_up.after).exit;
}
([entry, leaving] = self._ends(case_));
(steady = self._steady_end);
return (($eq(steady, "")) ? self.slack_end(case_) : (($eq(steady, "exit")) ? leaving : entry));
}
get states_uncertainty() {
const self = this; let of_cases, of_pulleys;

(of_pulleys = $b.any((function* () { for (const p of $iter(self.pulleys)) { yield $or(p.uncertainty, () => p.lagging.uncertainty); } })()));
(of_cases = $b.any((function* () { for (const case_ of $iter(self.load_cases)) { for (const of of $iter($m.values(case_.uncertainty))) { yield of; }} })()));
return $or(self.belt.is_uncertain, () => $or(of_pulleys, () => of_cases));
}
get take_up_place() {
const self = this; let after, away, ends, held, steady, take_up;

(take_up = self.criteria.take_up);
(ends = [...(function* () { for (const case_ of $iter(self.load_cases)) { yield self.slack_end(case_); } })()]);
if ((self.conveyor != null)) {
(held = self.conveyor.take_up);
(away = $b.any((function* () { for (const end of $iter(ends)) { yield ($b.abs($sub(end, held)) > $mul(1e-06, held)); } })()));
return ($truth(away) ? "at the take-up" : "");
}
if ($truth(take_up.fixed)) {
return ($truth(drive___alike(ends)) ? "" : ("" + "behind the drives in load case " + $str(self.load_case().name)));
}
(steady = self._steady_end);
if ((($eq(steady, "entry")) && !$truth(take_up.after))) {
return ("" + "at the take-up ahead of pulley " + $str($at(self.pulleys, 0).name));
}
(after = $or(take_up.after, () => (($eq(steady, "exit")) ? $at(self.pulleys, $neg(1)).name : "")));
return ($truth(after) ? ("" + "at the take-up behind pulley " + $str(after)) : "");
}
get _steady_end() {
const self = this; let drives, entries, exits, pulls, slack, steadier, tight;

(pulls = [...(function* () { for (const case_ of $iter(self.load_cases)) { yield drive___pull(case_); } })()]);
(entries = [...(function* () { for (const case_ of $iter(self.load_cases)) { yield $at(self._ends(case_), 0); } })()]);
(exits = [...(function* () { for (const case_ of $iter(self.load_cases)) { yield $at(self._ends(case_), 1); } })()]);
if (($b.min(pulls) < 0.0 && 0.0 < $b.max(pulls))) {
(steadier = ($mul($b.min(exits), $b.max(entries)) >= $mul($b.min(entries), $b.max(exits))));
return ($truth(steadier) ? "exit" : "entry");
}
(drives = ($b.min(pulls) >= 0.0));
([slack, tight] = ($truth(drives) ? [exits, entries] : [entries, exits]));
if (($truth(drive___alike(slack)) || !$truth(drive___alike(tight)))) {
return "";
}
return ($truth(drives) ? "entry" : "exit");
}
_ends(case_) {
const self = this; let first, last;
([first, last] = [$at(self.pulleys, 0).name, $at(self.pulleys, $neg(1)).name]);
return [$at(case_.tensions, first).entry, $at(case_.tensions, last).exit];
}
creep_limit_of(pulley) {
const self = this; 
return ((pulley.creep_limit == null) ? self.creep_limit : pulley.creep_limit);
}
}
$sig(Drive, ["title", "belt", "pulleys", "load_cases", "creep_limit", "criteria", "description", "conveyor", "read_from"], false, {title: () => "", creep_limit: () => 0.00635, criteria: () => new Criteria(), description: () => "", conveyor: () => null, read_from: () => null});
class ReadFrom extends $Object {
}
$sig(ReadFrom, ["document", "folder", "allow_paths"], false, {folder: () => "", allow_paths: () => false});
class Train extends $Object {
__post_init__() {
const self = this; let case_, count, given, least, message, names, problems;
(problems = limits__limit_problems(self, $bound(self, "LIMITS")));
(count = $b.len($bound(self, "pulleys")));
if (!(1 <= count && count <= 10)) {
(message = ("" + "a train needs 1 to " + $str(10) + " pulleys"));
$m.append(problems, new Problem(message, undefined, undefined, "pulley", $b.str(count)));
}
(problems = $add(problems, drive__repeated("pulley", (function* () { for (const p of $iter(self.pulleys)) { yield p.name; } })())));
(problems = $add(problems, drive__repeated("load_case", (function* () { for (const c of $iter(self.cases)) { yield c.name; } })())));
(problems = $add(problems, self.criteria.take_up.place_problems([...(function* () { for (const p of $iter(self.pulleys)) { yield p.name; } })()])));
if (!$truth(self.cases)) {
$m.append(problems, new Problem("a train needs a load case", undefined, undefined, "load_case"));
}
if ($truth(self.nominal_diameters)) {
(problems = $add(problems, train___count_problems("nominal_diameters", $bound(self, "nominal_diameters"), count)));
if (!$truth($b.all((function* () { for (const d of $iter(self.nominal_diameters)) { yield (0.0 < d && d < Infinity); } })()))) {
(message = "must be positive and finite");
(given = $b.str($b.list($bound(self, "nominal_diameters"))));
$m.append(problems, new Problem(message, undefined, undefined, "nominal_diameters", given));
}
}
(names = [...(function* () { for (const p of $iter(self.pulleys)) { yield p.name; } })()]);
for (case_ of $iter(self.cases)) {
(problems = $add(problems, train___case_problems(case_, names)));
(problems = $add(problems, drive__condition_problems($bound(case_, "name"), $bound(case_, "condition"), $bound(self, "pulleys"))));
(least = $b.min($bound(case_, "entry_tension"), $bound(case_, "exit_tension")));
(problems = $add(problems, drive__flying_problems($bound(self, "belt"), ("" + "load_case." + $str(case_.name)), least)));
}
(problems = $add(problems, drive__side_problems($bound(self, "belt"), $bound(self, "pulleys"))));
(problems = $add(problems, drive__covered_problems($bound(self, "criteria"), $bound(self, "conditions"), $bound(self, "pulleys"))));
limits__raise_all(problems);
}
static of(drive) {
const cls = this; 
return $call(cls, [], [["title", drive.title], ["description", drive.description], ["belt", drive.belt], ["pulleys", drive.pulleys], ["cases", $b.tuple((function* () { for (const case_ of $iter(drive.load_cases)) { yield train___case_of(drive, case_); } })())], ["creep_limit", drive.creep_limit], ["criteria", drive.criteria], ["read_from", drive.read_from]]);
}
get nominal() {
const self = this; 
return $or(self.nominal_diameters, () => $b.tuple((function* () { for (const p of $iter(self.pulleys)) { yield p.diameter; } })()));
}
case(name = "") {
const self = this; 
if (!$truth(name)) {
return load_case__heaviest($bound(self, "cases"), ((case_) => $sub(case_.entry_tension, case_.exit_tension)));
}
return drive__named("load case", name, $bound(self, "cases"), "the train");
}
get conditions() {
const self = this; 
return $b.tuple($b.fromkeys((function* () { for (const c of $iter(self.cases)) { if (!($truth(c.condition))) continue; yield c.condition; } })()));
}
get laggings() {
const self = this; 
return drive__laggings_of($bound(self, "pulleys"), [...(function* () { for (const case_ of $iter(self.cases)) { yield case_.condition; } })()]);
}
in_case(case_) {
const self = this; 
if (!$truth(case_.condition)) {
return self;
}
return $replaced(self, new Map([["pulleys", $b.tuple((function* () { for (const p of $iter(self.pulleys)) { yield p.in_condition($bound(case_, "condition")); } })())]]));
}
creep_limit_of(pulley) {
const self = this; 
return ((pulley.creep_limit == null) ? self.creep_limit : pulley.creep_limit);
}
}
$sig(Train, ["title", "description", "belt", "pulleys", "cases", "nominal_diameters", "creep_limit", "criteria", "read_from", "conveyor"], false, {title: () => "", description: () => "", nominal_diameters: () => [], creep_limit: () => 0.00635, criteria: () => new Criteria(), read_from: () => null, conveyor: () => null});
class Reader extends $Object {
$init(record, belt, pulleys, report, take_up) {
const self = this; ([self.belt, self.pulleys, self._report, self._take_up] = [belt, pulleys, report, take_up]);
(self._record = record);
(self._train = $at(record, "train"));
(self.nominal = $b.tuple((function* () { for (const p of $iter(pulleys)) { yield p.diameter; } })()));
(self.actual = self._with_actual_diameters());
}
_with_actual_diameters() {
const self = this; let diameters;
(diameters = $m.get(self._train, "diameters"));
if (((diameters == null) || !$truth(self._counted($bound(self, "_train"), "diameters")))) {
return $b.tuple($bound(self, "pulleys"));
}
return $b.tuple((function* () { for (const [pulley, d] of $iter($b.zip($bound(self, "pulleys"), diameters, $k({strict: true})))) { yield $replaced(pulley, new Map([["diameter", d]])); } })());
}
_counted(record, key) {
const self = this; let message;

if (($eq($b.len($at(record, key)), $b.len($bound(self, "pulleys"))))) {
return true;
}
(message = ("" + "must have one value for each of the " + $str($b.len($bound(self, "pulleys"))) + " pulleys, in belt order"));
$method(self._report, "add", [[...$iter(record.place), key], message], [["value", $at(record.raw, key)]]);
return false;
}
cases() {
const self = this; let built, case_, empty, over, speed, table, tables, train;

([train, speed] = [self._train, self.belt.speed]);
(tables = [...(function* () { for (const c of $iter($or($m.get(self._record, "load_case"), () => []))) { if (!($truth($b.isinstance(c, Record)))) continue; yield c; } })()]);
(built = []);
if ((!$truth(tables) || $truth(tensions__complete([self._given(train, null)], speed)) || $truth(self._powers(train)))) {
$m.append(built, self._case("design", train, null));
}
for (table of $iter(tables)) {
(over = $m.get(table, "train"));
(empty = new Record($map([]), [...$iter(table.place), "train"], $map([])));
(case_ = self._case($at(table, "name"), train, ((over != null) ? over : empty)));
$m.append(built, $and(case_, () => $replaced(case_, new Map([["kind", $m.get(table, "kind", "running")], ["condition", conditions__condition_name(table)], ["description", $m.get(table, "description", "")]]))));
}
return [...(function* () { for (const case_ of $iter(built)) { if (!((case_ != null))) continue; yield case_; } })()];
}
_case(name, train, over) {
const self = this; let division, error, given, message, place, pull, runs, tensions, total;
(place = ((over == null) ? train.place : over.place));
(runs = self._runs(train, over));
(division = self._division(train, over));
(given = self._given(train, over));
(pull = self._powers((((over == null) || (!$in("share", over))) ? train : over)));
if (($truth(pull) && ($b.len(tension_rules__families($bound(given, "values"))) < 2))) {
(given = $replaced(given, new Map([["values", $replaced(given.values, new Map([["effective_tension", pull]]))]])));
}
(given = given.less_runs($b.sum(runs), $bound(self.belt, "speed")));
(given = self._held(given, train, over, runs, division));
(tensions = $m.get(tensions__resolve([given], $bound(self.belt, "speed"), $bound(self, "_report")), $bound(given, "name")));
if (((division == null) || (tensions == null))) {
return null;
}
(total = $add(tensions.effective, $b.sum(runs)));
if (($truth(pull) && ($b.abs($sub(total, pull)) > $mul(0.005, $b.abs(pull))))) {
(message = ("" + "the powers make " + $str(display__display(pull, "force")) + ", the tensions " + $str(display__display(total, "force"))));
self._report.add([...$iter(place), "share"], message, "Leave one of them out.");
return null;
}
try {
return new TrainCase(name, tensions.entry, tensions.exit, division, ($truth($b.any(runs)) ? runs : []), undefined, undefined, undefined, $merged(self._uncertainty(train), self._uncertainty(over)));
} catch ($error) {
if ($error instanceof InputError) {
error = $error;
self._report.take(error, place);
return null;
} else throw $error;
}
}
_uncertainty(record) {
const self = this; return ((record == null) ? $map([]) : uncertain__read_uncertainty(record, $c26fe, $bound(self, "_report")));
}
division() {
const self = this; 
return self._division($bound(self, "_train"), null);
}
_given(train, over) {
const self = this; let fixed, given, runs;
(given = Given.of("train", train, null));
if ((over == null)) {
return given;
}
([runs, fixed] = [$ca1a4, self._take_up.fixed]);
if ($truth(fixed)) {
(runs = new RunsGain($b.sum(self._runs(train, null)), $b.sum(self._runs(train, over))));
}
return $method(given, "overridden", [over], [["fixed", fixed], ["speed", self.belt.speed], ["runs", runs]]);
}
_held(given, train, over, runs, division) {
const self = this; let after, base, ends, first, k, message, names, own;

([names, after] = [[...(function* () { for (const p of $iter(self.pulleys)) { yield p.name; } })()], self._take_up.after]);
if (((over == null) || (!$in(after, $slice(names, null, $neg(1)))) || ($in("entry_tension", over)) || ($in("exit_tension", over)))) {
return given;
}
if (((division == null) || !$truth($b.any((function* () { for (const key of $iter([...$iter($cf273), ...$iter($c3ab3), "run"])) { yield ($in(key, over)); } })())))) {
return given;
}
([own, base] = [self._runs(train, null), self._division(train, null)]);
if ((!$truth($b.isinstance(division, Shares)) || !$truth($b.isinstance(base, Shares)))) {
(message = "Te alone does not fix the tensions behind the take-up");
self._report.add($bound(over, "place"), message, "Give exit_tension too.");
return given;
}
(first = self._given(train, null).less_runs($b.sum(own), $bound(self.belt, "speed")));
(k = $add($m.index(names, after), 1));
(ends = tension_rules__behind_take_up(self._ends(given), self._ends(first), new BehindTakeUp($math.fsum($slice(division.fractions, k, null)), $b.sum($slice(runs, $sub(k, 1), null)), $b.sum(runs)), new BehindTakeUp($math.fsum($slice(base.fractions, k, null)), $b.sum($slice(own, $sub(k, 1), null)), $b.sum(own))));
if ((ends == null)) {
return given;
}
return $replaced(given, new Map([["values", new LoadGiven($bound(ends, "entry"), $bound(ends, "exit"))], ["inherited", []]]));
}
_ends(given) {
const self = this; return tension_rules__ends_of($bound(given, "values"), given.at($bound(self.belt, "speed")));
}
_runs(train, over) {
const self = this; let first, message, name, names, place, places, remedy, table;
(table = $b.dict($m.get(train, "run", $map([]))));
(places = $b.fromkeys(table, train.place));
if ((over != null)) {
(table = $merged(table, $m.get(over, "run", $map([]))));
(places = $merged(places, $b.fromkeys($m.get(over, "run", $map([])), over.place)));
}
(names = [...(function* () { for (const p of $iter(self.pulleys)) { yield p.name; } })()]);
for ([name, place] of $iter($m.items(places))) {
if ((!$in(name, $slice(names, 1, null)))) {
(first = ($in(name, names)));
(message = ($truth(first) ? "the first pulley has no run before it" : "no such pulley"));
(remedy = errors__name_remedy(name, $slice(names, 1, null)));
self._report.add([...$iter(place), "run", name], message, remedy);
}
}
return $b.tuple((function* () { for (const name of $iter($slice(names, 1, null))) { yield $m.get(table, name, 0.0); } })());
}
_division(train, over) {
const self = this; let message, modes, record;

(record = train);
if (((over != null) && $truth($b.any((function* () { for (const mode of $iter($c3ab3)) { yield ($in(mode, over)); } })())))) {
(record = over);
}
(modes = [...(function* () { for (const mode of $iter($c3ab3)) { if (!(($in(mode, record)))) continue; yield mode; } })()]);
if (($b.len(modes) > 1)) {
(message = ("" + $str($m.join(" and ", modes)) + " each decide how the load divides"));
self._report.add($bound(record, "place"), message, "Remove one of them.");
return null;
}
if (!$truth(modes)) {
if (($in("diameters", train))) {
return new Speeds($b.tuple((function* () { for (const d of $iter(self.nominal)) { yield (1.0 / d); } })()));
}
if (($eq($b.len($bound(self, "pulleys")), 1))) {
return new Shares([1.0]);
}
self._report.add($bound(record, "place"), "nothing says how the load divides", "Write share = [\"50 %\", \"50 %\"], speeds = \"equal\" or [train.motor.NAME].");
return null;
}
if (($eq(modes, ["motor"]))) {
return self._motors($at(record, "motor"), train);
}
return (($eq(modes, ["share"])) ? self._shares(record) : self._speeds(record));
}
_shares(record) {
const self = this; let kind, message, total, values;
if ((!$truth(self._counted(record, "share")) || !$truth(self._one_kind(record, "share")))) {
return null;
}
([kind, values] = [$at($at($at(record, "share"), 0), 0), [...(function* () { for (const [_, value] of $iter($at(record, "share"))) { yield value; } })()]]);
(total = (($eq(kind, "power")) ? $math.fsum(values) : 1.0));
if (($eq(total, 0.0))) {
(message = "the powers sum to 0, so that there is nothing to share");
$method(self._report, "add", [[...$iter(record.place), "share"], message], [["value", $at(record.raw, "share")]]);
return null;
}
return new Shares($b.tuple((function* () { for (const value of $iter(values)) { yield (value / total); } })()));
}
_powers(record) {
const self = this; let values;

(values = $m.get(record, "share"));
if ((!$truth(values) || ($in($ca9ba, values)) || (!$eq($at($at(values, 0), 0), "power")) || !$truth(self.belt.speed))) {
return null;
}
return ($math.fsum((function* () { for (const [_, value] of $iter(values)) { yield value; } })()) / self.belt.speed);
}
_speeds(record) {
const self = this; let kind, values;
if (($eq($at(record, "speeds"), "equal"))) {
return new Speeds($mul([1.0], $b.len($bound(self, "pulleys"))));
}
if ((!$truth(self._counted(record, "speeds")) || !$truth(self._one_kind(record, "speeds")))) {
return null;
}
([kind, values] = [$at($at($at(record, "speeds"), 0), 0), [...(function* () { for (const [_, value] of $iter($at(record, "speeds"))) { yield value; } })()]]);
if (($eq(kind, "rotation_speed"))) {
return new Speeds($b.tuple(values), true);
}
return new Speeds($b.tuple((function* () { for (const [v, d] of $iter($b.zip(values, $bound(self, "nominal"), $k({strict: true})))) { yield (v / d); } })()));
}
_one_kind(record, key) {
const self = this; let message;
if (($eq($b.len(new Set((function* () { for (const [kind, _] of $iter($at(record, key))) { yield kind; } })())), 1))) {
return true;
}
(message = "must be all of one kind");
$method(self._report, "add", [[...$iter(record.place), key], message], [["value", $at(record.raw, key)]]);
return false;
}
_motors(tables, train) {
const self = this; let made, missing, motors, name, names, place, remedy;
(names = [...(function* () { for (const p of $iter(self.pulleys)) { yield p.name; } })()]);
for (name of $iter((function* () { for (const name of $iter(tables)) { if (!((!$in(name, names)))) continue; yield name; } })())) {
(place = [...$iter(train.place), "motor", name]);
self._report.add(place, "no such pulley", errors__name_remedy(name, names));
}
(missing = [...(function* () { for (const name of $iter(names)) { if (!((!$in(name, tables)))) continue; yield name; } })()]);
for (name of $iter(missing)) {
(remedy = ("" + "Write [train.motor." + $str(name) + "] with kind = \"" + $str($b.next($b.iter($cc5ca))) + "\"."));
self._report.add([...$iter(train.place), "motor", name], "missing", remedy);
}
if (($truth(missing) || (!$eq($b.len(tables), $b.len(names))))) {
return null;
}
(motors = [...(function* () { for (const name of $iter(names)) { yield self._motor($at(tables, name)); } })()]);
(made = $b.tuple((function* () { for (const motor of $iter(motors)) { if (!((motor != null))) continue; yield motor; } })()));
return (($eq($b.len(made), $b.len(names))) ? new Motors(made) : null);
}
_motor(record) {
const self = this; let motor;
(motor = $ce9f3.built(record, $bound(self, "_report")));
return motor;
}
}
class Shares extends $Object {
}
$sig(Shares, ["fractions"], false, {});
class TrainCase extends $Object {
__post_init__() {
const self = this; let problems;
(problems = $add(limits__name_problems("name", $bound(self, "name")), limits__limit_problems(self, $bound(self, "LIMITS"))));
limits__raise_all($add(problems, uncertain__uncertainty_problems($bound(self, "uncertainty"), $c26fe)));
}
get effective_tension() {
const self = this; 
return $add($sub(self.entry_tension, self.exit_tension), $b.sum($bound(self, "runs")));
}
get pulls_given() {
const self = this; 
return $b.isinstance(self.division, Shares, Pulls);
}
run(index) {
const self = this; 
return ((index < $b.len($bound(self, "runs"))) ? $at(self.runs, index) : 0.0);
}
}
$sig(TrainCase, ["name", "entry_tension", "exit_tension", "division", "runs", "kind", "condition", "description", "uncertainty"], false, {runs: () => [], kind: () => "running", condition: () => "", description: () => "", uncertainty: () => new Map()});
class WrapArc extends $Object {
__post_init__() {
const self = this; let ends, key, least, message, most, problems, unit, value;
(problems = [...(function* () { for (const [key, value, unit] of $iter([["entry_tension", self.entry_tension, "N"], ["exit_tension", self.exit_tension, "N"], ["diameter", self.diameter, "m"], ["wrap_angle", self.wrap_angle, "rad"], ["width", self.width, "m"], ["creep_limit", self.creep_limit, "m"]])) { if (!(!(0.0 < value && value < Infinity))) continue; yield new Problem("must be positive and finite", undefined, undefined, key, ("" + $format(value, ("" + "g")) + " " + $str(unit))); } })()]);
if (!(0.0 <= self.thickness && self.thickness < Infinity)) {
(message = "must be 0 or positive, and finite");
$m.append(problems, new Problem(message, undefined, undefined, "thickness", ("" + $format(self.thickness, ("" + "g")) + " m")));
}
if (((self.overrun != null) && !$truth($math.isfinite($bound(self, "overrun"))))) {
(message = "must be finite");
$m.append(problems, new Problem(message, undefined, undefined, "overrun", ("" + $format(self.overrun, ("" + "g")) + " m")));
}
(problems = $add(problems, [...(function* () { for (const [key, value, unit] of $iter([["axial_stiffness", self.axial_stiffness, "N"], ["shear_modulus", self.shear_modulus, "Pa"], ["compression_modulus", self.compression_modulus, "Pa"]])) { if (!(!(value > 0.0))) continue; yield new Problem("must be positive", undefined, undefined, key, ("" + $format(value, ("" + "g")) + " " + $str(unit))); } })()]));
(least = $b.min($bound(self, "entry_tension"), $bound(self, "exit_tension")));
(least = ((least > 0.0) ? least : Infinity));
for ([key, value, unit, most] of $iter([["pitch_offset", $or(self.pitch_offset, () => 0.0), "m", Infinity], ["cover_compliance", self.cover_compliance, "m/Pa", Infinity], ["centrifugal", self.centrifugal, "N", least]])) {
if (!(0.0 <= value && value < most)) {
(ends = $add("at least 0", (($eq(most, Infinity)) ? "" : ", and less than the tensions")));
(message = ("" + "must be " + $str(ends)));
$m.append(problems, new Problem(message, undefined, undefined, key, ("" + $format(value, ("" + "g")) + " " + $str(unit))));
}
}
if (!$truth(problems)) {
(problems = self._law_problems());
}
if ($truth(problems)) {
throw new InputError(problems);
}
}
_law_problems() {
const self = this; let fall, held, law, problems, top;
(problems = []);
(top = self.wrap_pressure($b.max($bound(self, "entry_tension"), $bound(self, "exit_tension"))));
if ($truth(summary__too_steep(self.described(), self.law.steepest_fall()))) {
(fall = ($neg(1.0) / $mul(self.shear_compliance, top)));
$m.append(problems, new Problem(("" + "post_peak_slope must be more than " + $format(fall, ("" + "g")) + " 1/m"), "Check slope, thickness and shear modulus.", undefined, "lagging", ("" + $format(self.law.steepest_fall(), ("" + "g")) + " 1/m")));
}
(law = self.law.compact());
if ($truth(summary__overrun_loosens(law, self.geometry(), $bound(self, "entry_pressure")))) {
(held = summary__held_creep(law, $bound(self, "shear_compliance"), $bound(self, "entry_pressure")));
$m.append(problems, new Problem(("" + "must be within " + $format(held, ("" + "g")) + " m of 0, where this law starts to slip"), "Write overrun = \"0 mm\".", undefined, "overrun", ("" + $format(self.entry_overrun, ("" + "g")) + " m")));
}
return problems;
}
static of(drive, pulley, case_) {
const cls = this; let lagging, tensions;

([lagging, tensions] = [pulley.lagging_in($bound(case_, "condition")), $at(case_.tensions, pulley.name)]);
return $method(cls, "on", [$bound(drive, "belt"), pulley, lagging], [["entry_tension", tensions.entry], ["exit_tension", tensions.exit], ["creep_limit", drive.creep_limit_of(pulley)], ["belt_speed", wrap_arc___speed_at(drive, case_, $bound(tensions, "entry"))], ["fit", lagging.fit], ["growth", pull__growth_in(drive, case_, pulley)], ["load_case", case_.name]]);
}
static on(belt, pulley, lagging, more = new Map()) {
const cls = this; 
return $call(cls, [], [["law", lagging.law], ...wrap_arc__of_belt(belt, $bound(pulley, "side"), $bound(lagging, "law")), ["diameter", pulley.diameter], ["wrap_angle", pulley.wrap_angle], ["width", belt.width], ["axial_stiffness", belt.axial_stiffness], ["thickness", lagging.thickness], ["shear_modulus", lagging.shear_modulus], ["compression_modulus", lagging.compression_modulus], ["overrun", pulley.overrun], ["recovery", pulley.recovery], ["wear_coefficient", lagging.wear_coefficient], ["pulley", pulley.name], ...more]);
}
get radius() {
const self = this; 
return $mul(0.5, self.diameter);
}
get length() {
const self = this; 
return $mul(self.radius, self.wrap_angle);
}
get effective_tension() {
const self = this; 
return $sub(self.entry_tension, self.exit_tension);
}
get duty() {
const self = this; let pull;

(pull = self.effective_tension);
return ((pull > 0.0) ? "driving" : ((pull < 0.0) ? "braking" : "idling"));
}
get side() {
const self = this; 
return ((self.entry_tension >= self.exit_tension) ? 1.0 : $neg(1.0));
}
wrap_pressure(tension) {
const self = this; 
return ($mul(2.0, $sub(tension, self.centrifugal)) / $mul(self.width, self.diameter));
}
get entry_pressure() {
const self = this; 
return self.wrap_pressure($bound(self, "entry_tension"));
}
get offset() {
const self = this; 
return $or(self.pitch_offset, () => 0.0);
}
get shear_compliance() {
const self = this; 
return $add(self.lagging_compliance, self.cover_compliance);
}
get lagging_compliance() {
const self = this; 
return ($truth(self.slip_with_shear) ? 0.0 : (self.thickness / self.shear_modulus));
}
get slip_with_shear() {
const self = this; 
return (pitch__counts_shear($bound(self, "law"), "lagging shear") === true);
}
get entry_overrun() {
const self = this; let found, pressure;

([found, pressure] = [self.geometry(), self.entry_pressure]);
return $add(found.overrun_constant, $mul($mul(found.overrun_coefficient, pressure), $math.sqrt(pressure)));
}
described() {
const self = this; 
return new Description(self.entry_tension, self.exit_tension, self.diameter, self.wrap_angle, self.width, self.axial_stiffness, self.thickness, self.shear_modulus, self.compression_modulus, ((self.overrun == null) ? NaN : self.overrun), self.recovery, ((self.belt_speed == null) ? NaN : self.belt_speed), ((self.wear_coefficient == null) ? NaN : self.wear_coefficient), self.shear_compliance, self.offset, self.centrifugal);
}
geometry() {
const self = this; 
return summary__geometry_of(self.described());
}
load() {
const self = this; let ends, tested;

(tested = self.law.tested);
(ends = [NaN, NaN, NaN]);
if ((tested != null)) {
(ends = [tested.pressure_min, tested.pressure_max, tested.slip_max]);
}
return new Load($sub(self.entry_tension, self.centrifugal), $sub(self.exit_tension, self.centrifugal), $bound(self, "creep_limit"), ...$iter(ends), self.law.steepest_fall());
}
get compliance() {
const self = this; 
return $add((1.0 / self.axial_stiffness), self.recovery_compliance);
}
get recovery_compliance() {
const self = this; 
return summary__recovery_compliance(self.described());
}
}
$sig(WrapArc, ["law", "entry_tension", "exit_tension", "diameter", "wrap_angle", "width", "axial_stiffness", "thickness", "shear_modulus", "compression_modulus", "overrun", "recovery", "creep_limit", "belt_speed", "wear_coefficient", "pitch_offset", "cover_compliance", "cover_left_out", "side_of_belt", "belt_thickness", "centrifugal", "fit", "growth", "pulley", "load_case"], false, {thickness: () => 0.0, shear_modulus: () => Infinity, compression_modulus: () => Infinity, overrun: () => null, recovery: () => true, creep_limit: () => 0.00635, belt_speed: () => null, wear_coefficient: () => null, pitch_offset: () => null, cover_compliance: () => 0.0, cover_left_out: () => 0.0, side_of_belt: () => "pulley", belt_thickness: () => null, centrifugal: () => 0.0, fit: () => null, growth: () => $c6b61, pulley: () => "", load_case: () => ""});
class in_page$Given extends $Tuple {
}
$sig(in_page$Given, ["entry_tension", "exit_tension", "effective_tension", "torque", "power", "diameter", "wrap_angle", "overrun", "recovery", "width", "modulus", "speed", "thickness", "shear_modulus", "compression_modulus", "wear_coefficient", "creep_limit", "steepest_fall", "pitch_offset", "cover_compliance", "mass", "slip_with_shear", "belt_speed"], false, {});
class Rise extends $Object {
}
$sig(Rise, ["tight", "slack"], false, {});
class in_page$Criteria extends $Tuple {
}
$sig(in_page$Criteria, ["safety", "tight_rise", "slack_rise", "cover", "strength", "pulley_mass", "wet"], false, {});
class At extends $Object {
}
$sig(At, ["drive", "case", "pulley"], false, {});
class ArcResult extends Viewable {
get creep_interval() { return $kept(this, "creep_interval", this.$find_creep_interval()); }
get covered_creep() { return $kept(this, "covered_creep", this.$find_covered_creep()); }
get effective_tension() {
const self = this; 
return $sub(self.entry_tension, self.exit_tension);
}
get k_factor() {
const self = this; let length;

(length = $mul(self.arc.radius, self.active_arc));
return summary__spring_rate($bound(self.arc, "axial_stiffness"), length, $bound(self, "exit_creep"));
}

get sticks() {
const self = this; 
return (self.stuck_arc > 1e-09);
}
get extrapolates() {
const self = this; 
return (self.outside_tested_share > 1e-09);
}
get share_of_limit() {
const self = this; 
return ($b.abs($bound(self, "exit_creep")) / self.arc.creep_limit);
}
get within_creep_limit() {
const self = this; 
return $and($told($cc303, self.status, "solved"), () => ($b.abs($bound(self, "exit_creep")) <= self.arc.creep_limit));
}
$find_covered_creep() {
const self = this; let arc, found, geometry, load, series;

(arc = self.arc);
if ((!$truth($told($cc303, self.status, "solved")) || ($eq(arc.cover_left_out, 0.0)))) {
return NaN;
}
([load, geometry] = [arc.load(), arc.geometry()]);
(series = $replaced(geometry, new Map([["shear", $add(geometry.shear, arc.cover_left_out)]])));
(found = answer__operating_point(arc.law.compact(), series, $bound(load, "entry_tension"), $bound(load, "exit_tension")));
if ((!$eq(found.outcome, 0))) {
return $math.copysign(Infinity, $bound(arc, "side"));
}
return $at(found.met.course.creep, $neg(1));
}
}
$sig(ArcResult, ["status", "method", "arc", "profile", "entry_tension", "exit_tension", "exit_creep", "creep_shrinkage", "creep_compression", "creep_global", "exit_slip", "entry_creep_ratio", "exit_creep_ratio", "peak_shear_stress", "peak_shear_angle", "peak_shear_position", "mean_friction", "active_arc", "outside_tested_share", "stuck_arc", "capacities", "energy", "steepest_slip"], false, {steepest_slip: () => NaN});
class FoundArc extends ArcResult {
get creep_interval() {
const self = this; 
return [NaN, NaN];
}
get covered_creep() {
const self = this; 
return self.found.covered_creep;
}
}
$sig(FoundArc, ["status", "method", "arc", "profile", "entry_tension", "exit_tension", "exit_creep", "creep_shrinkage", "creep_compression", "creep_global", "exit_slip", "entry_creep_ratio", "exit_creep_ratio", "peak_shear_stress", "peak_shear_angle", "peak_shear_position", "mean_friction", "active_arc", "outside_tested_share", "stuck_arc", "capacities", "energy", "steepest_slip", "found"], false, {steepest_slip: () => NaN});
class DriveResult extends Viewable {
__iter__() {
const self = this; return $b.iter($bound(self, "arcs"));
}
arc(pulley, load_case = "") {
const self = this; let found, name;

(found = $map([...(function* () { for (const result of $iter(self)) { if (!(($eq(result.arc.pulley, pulley)))) continue; yield [result.arc.load_case, result]; } })()]));
(name = $or(load_case, () => self.drive.load_case().name));
if ((!$in(name, found))) {
throw new $KeyError([pulley, load_case]);
}
return $at(found, name);
}
get governing() {
const self = this; let worst;

function severity(result) {
let margin;
if ((result.status === "The solver did not reach its accuracy on this arc. Please report the drive file; until then change a value slightly.")) {
return [2.0, 0.0];
}
if ((result.status === "Gross slip: no creep gives enough friction for this tension ratio. Raise the slack-side tension (take-up), increase the wrap angle, or choose a lagging with more friction.")) {
(margin = result.capacities.extrapolated_gross_slip_margin);
return [1.0, ($truth($math.isfinite(margin)) ? $neg(margin) : 0.0)];
}
return [0.0, result.share_of_limit];
}
$sig(severity, ["result"], false);
(worst = $b.max((function* () { for (const result of $iter(self.arcs)) { yield $at(severity(result), 0); } })()));
return alike__largest((function* () { for (const result of $iter(self.arcs)) { if (!(($eq($at(severity(result), 0), worst)))) continue; yield result; } })(), ((result) => $at(severity(result), 1)));
}
get solved() {
const self = this; 
return $b.all((function* () { for (const r of $iter(self.arcs)) { yield $told($cc303, r.status, "solved"); } })());
}
get within_creep_limit() {
const self = this; 
return $b.all((function* () { for (const r of $iter(self.arcs)) { yield r.within_creep_limit; } })());
}
}
$sig(DriveResult, ["drive", "arcs"], false, {});
class TrainResult extends Viewable {
get _pulley_by_pulley() { return $kept(this, "_pulley_by_pulley", this.$find__pulley_by_pulley()); }
__iter__() {
const self = this; return $b.iter($bound(self, "cases"));
}
get adrift() {
const self = this; 
return $b.any((function* () { for (const c of $iter(self.cases)) { yield c.adrift; } })());
}
get solved() {
const self = this; 
return $b.all((function* () { for (const c of $iter(self.cases)) { yield $told($cc303, c.status, "solved"); } })());
}
get governing() {
const self = this; let solved;

function severity(case_) {
let creeps;
(creeps = [...(function* () { for (const m of $iter(case_.members)) { yield m.arc.share_of_limit; } })()]);
return $b.max((function* () { for (const c of $iter(creeps)) { yield ($truth($math.isfinite(c)) ? c : 0.0); } })());
}
$sig(severity, ["case"], false);
(solved = $told($cc303, self, "solved"));
return alike__largest((function* () { for (const c of $iter(self.cases)) { if (!(($truth(solved) || !$truth($told($cc303, c.status, "solved"))))) continue; yield c; } })(), severity);
}
drive_result() {
const self = this; 
return self._pulley_by_pulley;
}
$find__pulley_by_pulley() {
const self = this; let arcs, cases;
(cases = [...(function* () { for (const result of $iter(self.cases)) { yield new LoadCase(result.case.name, $map([...(function* () { for (const m of $iter(result.members)) { yield [m.name, new Tensions(m.arc.entry_tension, m.arc.exit_tension)]; } })()]), result.case.kind, result.case.condition, result.case.description, ($truth(result.case.uncertainty) ? $map([["", result.case.uncertainty]]) : $map([]))); } })()]);
(arcs = $b.tuple((function* () { for (const case_ of $iter(self.cases)) { for (const m of $iter(case_.members)) { yield m.arc; }} })()));
return new DriveResult(result__drive_with($bound(self, "train"), cases), arcs);
}
}
$sig(TrainResult, ["train", "cases"], false, {});
class CaseResult extends $Object {
__iter__() {
const self = this; return $b.iter($bound(self, "members"));
}
get adrift() {
const self = this; 
return $and((self.status === "Gross slip: a drive cannot transmit its share of the load. Raise the slack-side tension (take-up), bring the speeds closer together, or choose a lagging with more friction."), () => !$truth(self.case.pulls_given));
}
get within_creep_limit() {
const self = this; 
return $and($told($cc303, self.status, "solved"), () => $b.all((function* () { for (const m of $iter(self.members)) { yield m.arc.within_creep_limit; } })()));
}
}
$sig(CaseResult, ["case", "status", "reason", "members", "sensitivity", "belt_speed", "other_splits", "tension_error", "speed_error"], false, {other_splits: () => [], tension_error: () => 0.0, speed_error: () => 0.0});
class MemberResult extends $Object {
get name() {
const self = this; 
return self.arc.arc.pulley;
}
}
$sig(MemberResult, ["arc", "share", "speed_ratio", "contraction_term", "creep_term", "compression_term", "thickness_term", "drum_ratio", "surface_speed", "rotation_speed", "speed_trim", "drum_torque", "drum_power", "motor"], false, {motor: () => null});
class Place extends $Tuple {
__str__() {
const self = this; let case_, more, names, parts;
([case_, more] = [self.load_case, ("" + ", " + $str(self.condition))]);
if (($truth(self.condition) && $truth($m.endswith(case_, more)))) {
(case_ = $slice(case_, null, $sub($b.len(case_), $b.len(more))));
}
(names = [self.pulley, self.spot, case_, self.event, self.condition]);
(parts = [...(function* () { for (const name of $iter(names)) { if (!($truth(name))) continue; yield (($in(",", name)) ? ("" + "\"" + $str(name) + "\"") : name); } })()]);
if ((self.time != null)) {
$m.append(parts, cell__quantity($bound(self, "time"), "time"));
}
return $m.join(", ", parts);
}
get bracket() {
const self = this; let names;

(names = $b.str(self));
return ($truth(names) ? ("" + " (" + $str(names) + ")") : "");
}
}
$sig(Place, ["pulley", "load_case", "event", "spot", "condition", "time"], false, {pulley: () => "", load_case: () => "", event: () => "", spot: () => "", condition: () => "", time: () => null});
class Motors extends $Object {
}
$sig(Motors, ["motors"], false, {});
class Motor extends $Object {
__post_init__() {
const self = this; let message, problems;
(problems = limits__limit_problems(self, $bound(self, "LIMITS")));
if ((!$eq(self.count, $b.int($bound(self, "count"))))) {
(message = "must be a whole number of motors");
$m.append(problems, new Problem(message, undefined, undefined, "count", ("" + $format(self.count, ("" + "g")))));
}
limits__raise_all($add(problems, self._problems()));
}
_problems() {
const self = this; 
return [];
}
get drum_torque() {
const self = this; 
return $mul($mul(self.count, self.gear_ratio), self.rated_torque);
}
bears(momentary) {
const self = this; 
return ($truth(momentary) ? $b.min(1.6, self.largest_load()) : 1.0);
}
load(drum_torque) {
const self = this; let eta;

(eta = ((drum_torque >= 0.0) ? self.gear_efficiency : (1.0 / self.gear_efficiency)));
return (drum_torque / $mul(eta, self.drum_torque));
}
drum_speed(drum_torque) {
const self = this; let end, excess, load, speed, within;

([load, end] = [self.load(drum_torque), self.largest_load()]);
(within = $b.min($b.max(load, $neg(end)), end));
(excess = $sub(load, within));
(speed = (self.shaft_speed(within) / self.gear_ratio));
return $mul(speed, $math.exp($mul($neg(10.0), $math.copysign($math.log1p($b.abs(excess)), excess))));
}
limits() {
const self = this; let end;

(end = self.largest_load());
return [($truth(self.brakes) ? $neg(end) : 0.0), end];
}
get rated_torque() {
const self = this; 
return (self.rated_power / self.rated_speed);
}
}
$sig(Motor, ["rated_power", "rated_speed", "gear_ratio", "gear_efficiency", "motor_efficiency", "count", "brakes"], false, {gear_ratio: () => 1.0, gear_efficiency: () => 1.0, motor_efficiency: () => null, count: () => 1, brakes: () => true});
class Beyond extends $Tuple {
}
$sig(Beyond, ["name", "load", "end"], false, {});
class Check extends $Object {
get used() {
const self = this; 
return ($truth(self.below) ? NaN : numbers__used_of($bound(self, "value"), $bound(self, "limit"), $bound(self, "at_most")));
}
get compares() {
const self = this; 
return $and((!$in(self.name, $cfc62)), () => (self.level !== "NOT CHECKED"));
}
get below() {
const self = this; 
return $and(self.numerical, () => (self.level === "OK"));
}
get share() {
const self = this; let share, silent;

(silent = $or((self.level === "NOT CHECKED"), () => $or(self.numerical, () => !$truth(self.limit))));
(share = ($truth(silent) ? NaN : (self.value / self.limit)));
return ($truth($math.isfinite(share)) ? share : NaN);
}
get missed() {
const self = this; 
return ($told($c7ecb, self.level, "rank") >= $told($c7ecb, "ATTENTION", "rank"));
}
get order() {
const self = this; let place, unknown;

(unknown = (self.level === "NOT CHECKED"));
(place = numbers__order_of($bound(self, "used"), $bound(self, "missed"), numbers__kind_of($bound(self, "name"), (self.level === "FAILS"))));
return [$neg(($truth(unknown) ? $add($told($c7ecb, "OK", "rank"), 0.5) : $told($c7ecb, self.level, "rank"))), place];
}
texts() {
const self = this; let form, limit, more, other, power, shown, value;

if ($truth(self.below)) {
(power = digits__exponent_of(digits__scientific($bound(self, "limit"), 0)));
return [("" + "< 1e" + $str(power)), ("" + "1e" + $str(power))];
}
([value, limit, more] = [self.value, self.limit, ""]);
if ($truth(self.is_percent)) {
([value, limit, more] = [$mul(100.0, value), $mul(100.0, limit), " %"]);
}
if (!$truth(self.missed)) {
(shown = check__quantity_text(value, $bound(self, "dimension")));
(other = ($truth($math.isnan(limit)) ? "" : self._limit(limit, NaN)));
} else {
(form = ($truth(self.at_most) ? "exceeds" : "below"));
(shown = check__quantity_text(value, $bound(self, "dimension"), limit, form));
(other = ($truth($math.isnan(limit)) ? "" : self._limit(limit, value)));
}
return [($truth(shown) ? ("" + $str(shown) + $str(more)) : ""), ($truth(other) ? ("" + $str(other) + $str(more)) : "")];
}
_limit(limit, missed_by) {
const self = this; let sense;
(sense = ($truth(self.at_most) ? "maximum" : "minimum"));
return cell__format_limit(limit, $bound(self, "dimension"), sense, missed_by);
}
bound() {
const self = this; 
if ($truth($math.isnan($bound(self, "limit")))) {
return "";
}
return ("" + $str(($truth(self.at_most) ? "max" : "min")) + " " + $str($at(self.texts(), 1)));
}
get text() {
const self = this; let measured, reason, where;

if ((self.level === "NOT CHECKED")) {
(reason = ($truth(self.missing) ? ("" + $str(self.missing) + " missing") : self.why));
return ("" + $str(self.title) + " not checked: " + $str(reason) + ".");
}
if (!$truth(self.headline)) {
(measured = self.measured);
return ("" + $str(self.title) + $str(($truth(measured) ? ("" + ": " + $str(measured)) : "")) + $str(self.place.bracket) + ".");
}
(where = ($truth(self.is_placed) ? self.place.bracket : ""));
return ("" + $str(self._filled($bound(self, "headline"))) + $str(where) + ".");
}
get action_text() {
const self = this; 
return self._filled($bound(self, "action"));
}
_filled(template) {
const self = this; let limit, value, words;

([value, limit] = self.texts());
(words = $map([...(function* () { for (const name of $iter(self.more)) { yield [name, self._amount(name)]; } })()]));
(words = $merged(words, $map([["value", value], ["limit", limit]])));
return $m.format(template, [], $map([...words]));
}
_amount(name) {
const self = this; let nearest, of, others;

(of = $at(self.more, name));
if (($truth(of.form) && $truth($math.isfinite($bound(of, "value"))))) {
return cellOf($bound(of, "value"), $bound(of, "dimension"), undefined, of.form);
}
(others = [...(function* () { for (const [n, o] of $iter($m.items(self.more))) { if (!(((!$eq(n, name)) && ($eq(o.dimension, of.dimension))))) continue; yield o.value; } })()]);
(nearest = $b.min(others, $k({key: ((other) => $b.abs($sub(other, of.value))), default: NaN})));
return check__quantity_text($bound(of, "value"), $bound(of, "dimension"), nearest);
}
get numerical() {
const self = this; 
return ($in(self.name, $c7c4c));
}
get measured() {
const self = this; let limit, value;

([value, limit] = self.texts());
if ((!$truth(value) || !$truth(limit))) {
return value;
}
if (!$truth(self.at_most)) {
return ("" + $str(value) + ", minimum " + $str(limit));
}
if (($truth(self.below) || !($truth($math.isfinite($bound(self, "value"))) && $truth($math.isfinite($bound(self, "limit")))))) {
return ("" + $str(value) + " of " + $str(limit));
}
if ($truth(self.is_percent)) {
return ("" + $str(cellOf($mul(100.0, self.limit), "number", undefined, "of", $mul(100.0, self.value))) + " %");
}
return cellOf($bound(self, "limit"), $bound(self, "dimension"), undefined, "of", self.value);
}
get full_text() {
const self = this; 
return self._filled($bound(self, "full"));
}
}
$sig(Check, ["name", "title", "level", "place", "is_placed", "quantity", "noun", "value", "limit", "dimension", "is_percent", "at_most", "headline", "action", "full", "label", "source", "missing", "why", "more", "binding", "weak"], false, {place: () => $cb829, is_placed: () => true, quantity: () => "", noun: () => "", value: () => NaN, limit: () => NaN, dimension: () => "number", is_percent: () => false, at_most: () => true, headline: () => "", action: () => "", full: () => "", label: () => "", source: () => "", missing: () => "", why: () => "", more: () => new Map(), binding: () => true, weak: () => []});
class Pulls extends $Object {
}
$sig(Pulls, ["effective_tensions"], false, {});
class Amount extends $Tuple {
}
$sig(Amount, ["value", "dimension", "form"], false, {form: () => ""});
class CheckText extends $Object {
}
$sig(CheckText, ["title", "noun", "headline", "fails", "action", "full", "label", "source", "more", "missing", "why", "show_value"], false, {noun: () => "", headline: () => "", fails: () => "", action: () => "", full: () => "", label: () => "", source: () => "", more: () => new Map(), missing: () => "", why: () => "", show_value: () => false});
class Owner extends $Tuple {
}
$sig(Owner, ["of", "kinds", "words", "place", "more"], false, {place: () => $cb829, more: () => []});
class Speeds extends $Object {
}
$sig(Speeds, ["rotation_speeds", "absolute"], false, {absolute: () => false});
class Sliding extends $Tuple {
}
$sig(Sliding, ["place", "cause"], false, {});
class Spot extends At {
}
$sig(Spot, ["drive", "case", "pulley", "place", "state", "result", "unknown"], false, {result: () => null, unknown: () => ""});
class State extends $Object {
raised(by) {
const self = this; let end, slack, tight;

([tight, slack, end] = [$add(self.tight, by), $add(self.slack, by), $add(self.slack_end, by)]);
return $replaced(self, new Map([["tight", tight], ["slack", slack], ["slack_end", end]]));
}
}
$sig(State, ["tight", "slack", "slack_end", "width", "diameter", "strength", "centrifugal", "creep_limit", "motor", "found"], false, {});
class VariableSpeed extends Motor {
shaft_speed(load) {
const self = this; 
return $mul(self.rated_speed, $b.max($sub(self.setting, $mul(self.droop, load)), 0.001));
}
largest_load() {
const self = this; let stall;

(stall = ((self.droop > 0.0) ? ($mul(0.9, self.setting) / self.droop) : Infinity));
return $b.min($bound(self, "torque_limit"), stall);
}
}
$sig(VariableSpeed, ["rated_power", "rated_speed", "gear_ratio", "gear_efficiency", "motor_efficiency", "count", "brakes", "setting", "droop", "torque_limit"], false, {gear_ratio: () => 1.0, gear_efficiency: () => 1.0, motor_efficiency: () => null, count: () => 1, brakes: () => true, setting: () => 1.0, droop: () => 0.0, torque_limit: () => Infinity});
class Sizes extends $Tuple {
}
$sig(Sizes, ["width", "modulus", "speed", "diameter", "idle_wrap", "wrap_angle", "creep_limit", "overrun", "thickness", "shear_modulus", "compression_modulus", "rating", "strength", "bond_strength", "fatigue_limit", "face_pressure", "least_diameter", "sag", "entry", "leaving", "pull", "mass"], false, {});
class MassRange extends $Tuple {
}
$sig(MassRange, ["least", "most"], false, {});
class Verdict extends $Object {
get governing() { return $kept(this, "governing", this.$find_governing()); }
get listed() { return $kept(this, "listed", this.$find_listed()); }
get missed() { return $kept(this, "missed", this.$find_missed()); }
get _at() { return $kept(this, "_at", this.$find__at()); }
get _places() { return $kept(this, "_places", this.$find__places()); }
$find_governing() {
const self = this; let judged;

(judged = [...(function* () { for (const c of $iter(self.checks)) { if (!((c.level !== "NOT CHECKED"))) continue; yield c; } })()]);
return $b.min(judged, $k({key: verdict___order, default: null}));
}
get kind_in_doubt() {
const self = this; let here, worst;

(worst = self.governing);
if (((worst == null) || !$truth(worst.missed) || (!$in(worst.name, $cda4c)))) {
return null;
}
(here = (function* () { for (const c of $iter(self.missed)) { if (!((($eq(c.name, "case_kind")) && (!$eq(c.place.load_case, ""))))) continue; yield c; } })());
return $b.next((function* () { for (const c of $iter(here)) { if (!(($eq(c.place.load_case, worst.place.load_case)))) continue; yield c; } })(), null);
}
get level() {
const self = this; 
return ((self.governing == null) ? "OK" : self.governing.level);
}
get label() {
const self = this; let dry;

(dry = $and((self.wet != null), () => (self.wet.level === "NOT CHECKED")));
return (($truth(dry) && (self.level === "OK")) ? ("" + $str("OK") + " (dry)") : $b.str($bound(self, "level")));
}
get wet() {
const self = this; 
return $b.next((function* () { for (const c of $iter(self.listed)) { if (!(($eq(c.name, "wet_creep")))) continue; yield c; } })(), null);
}
get text() {
const self = this; let worst;

(worst = self.governing);
if ((worst == null)) {
return "Nothing checked.";
}
return ($truth(worst.missed) ? worst.text : self._passing());
}
_passing() {
const self = this; let count, text;
(count = self.passed);
(text = ((!$eq(count, 1)) ? ("" + "All " + $str(count) + " checks pass.") : "1 check passes."));
return ($truth(self.closest) ? ("" + $str(text) + " Closest: " + $str(self.closest) + ".") : text);
}
get also() {
const self = this; 
return $slice(self.missed, 1, null);
}
get wet_text() {
const self = this; let wet;

(wet = self.wet);
if (((wet == null) || $truth(wet.missed))) {
return "";
}
if ((wet.level === "NOT CHECKED")) {
return ((self.level === "OK") ? ("" + "Not checked: " + $str(wet.why) + ".") : "");
}
return ("" + "Creep " + $str($at(wet.texts(), 0)) + " (estimated) passes.");
}
$find_listed() {
const self = this; let check, current, worst;

(worst = $map([]));
for (check of $iter(self.checks)) {
(current = $m.get(worst, $bound(check, "name"), check));
$put(worst, check.name, $b.min(current, check, $k({key: verdict___order})));
}
return $b.tuple($m.values(worst));
}
$find_missed() {
const self = this; let missed, worst;

([missed, worst] = [(function* () { for (const c of $iter(self.listed)) { if (!($truth(c.missed))) continue; yield c; } })(), self.governing]);
return $b.tuple($b.sorted(missed, $k({key: ((check) => [(check !== worst), ...$iter(verdict___order(check))])})));
}
get passed() {
const self = this; 
return $b.sum((function* () { for (const c of $iter(self.listed)) { yield $and(c.compares, () => !$truth(c.missed)); } })());
}
get not_checked() {
const self = this; 
return $b.tuple((function* () { for (const c of $iter(self.listed)) { if (!((c.level === "NOT CHECKED"))) continue; yield c; } })());
}
get data() {
const self = this; 
return verdict__data_line($b.tuple((function* () { for (const c of $iter(self.checks)) { for (const item of $iter(c.weak)) { yield item; }} })()));
}
get remarks() {
const self = this; let texts;

(texts = (function* () { for (const c of $iter(self.checks)) { if (!((($in(c.name, ["data", "belt_mass"])) && $truth(c.full)))) continue; yield c.full_text; } })());
return $b.tuple($b.fromkeys(texts));
}
get full() {
const self = this; let texts;

(texts = [...(function* () { for (const c of $iter(self.missed)) { if (!($truth(c.full))) continue; yield ("" + $str(c.title) + ": " + $str(c.full_text)); } })()]);
return [...$iter($b.fromkeys(texts)), ...$iter(self._senses())];
}
_senses() {
const self = this; let every, here, senses, texts, title;

(every = $sub(new Set((function* () { for (const c of $iter(self.checks)) { yield c.place.load_case; } })()), new Set([""])));
(senses = [...(function* () { for (const c of $iter(self.checks)) { if (!(($eq(c.name, "sense")))) continue; yield c; } })()]);
(texts = []);
for (title of $iter($b.fromkeys((function* () { for (const c of $iter(senses)) { yield c.title; } })()))) {
(here = new Set((function* () { for (const c of $iter(senses)) { if (!(($eq(c.title, title)))) continue; yield c.place.load_case; } })()));
$m.append(texts, ("" + $str(title) + " in " + $str($b.len(here)) + " of " + $str($b.len(every)) + " load cases."));
}
return texts;
}
at(pulley, load_case) {
const self = this; let known, mine, own, places, there;

(known = $m.setdefault(self._at, load_case, $map([])));
if ((!$in(pulley, known))) {
(places = $b.fromkeys(["", load_case]));
(there = $b.sorted((function* () { for (const place of $iter(places)) { for (const n of $iter($m.get(self._places, place, []))) { yield n; }} })()));
(mine = [...(function* () { for (const number of $iter(there)) { yield $at(self.checks, number); } })()]);
(own = $b.tuple((function* () { for (const check of $iter(mine)) { if (!(($in(check.place.pulley, ["", pulley])))) continue; yield check; } })()));
$put(known, pulley, (($eq($b.len(own), $b.len($bound(self, "checks")))) ? self : new Verdict(own)));
}
return $at(known, pulley);
}
within(load_case) {
const self = this; let own;

(own = $b.tuple((function* () { for (const c of $iter(self.checks)) { if (!(($in(c.place.load_case, ["", load_case])))) continue; yield c; } })()));
return (($eq($b.len(own), $b.len($bound(self, "checks")))) ? self : new Verdict(own));
}
$find__at() {
const self = this; return $map([]);
}
$find__places() {
const self = this; let check, found, number;
(found = $map([]));
for ([number, check] of $iter($b.enumerate($bound(self, "checks")))) {
$m.append($m.setdefault(found, $bound(check.place, "load_case"), []), number);
}
return found;
}
get closest() {
const self = this; let worst;

(worst = self.governing);
if (((worst == null) || !$truth($math.isfinite($bound(worst, "used"))))) {
return "";
}
return ("" + $str($or(worst.noun, () => worst.title)) + " " + $str(worst.measured) + $str(worst.place.bracket));
}
}
$sig(Verdict, ["checks"], false, {});
class Figure extends $Object {
}
$sig(Figure, ["name", "title", "tension", "place", "binding", "at_least"], false, {binding: () => true, at_least: () => true});
class StandardRequirement extends $Object {
}
$sig(StandardRequirement, ["name", "how", "wrap_factor", "source", "why_not", "remedy"], false, {why_not: () => "", remedy: () => "Set design_standard.friction."});
class LeastTension extends $Object {
get required() { return $kept(this, "required", this.$find_required()); }
get governing() { return $kept(this, "governing", this.$find_governing()); }
get highest() { return $kept(this, "highest", this.$find_highest()); }
$find_required() {
const self = this; let below, top;

(top = ((self.highest == null) ? Infinity : self.highest.tension));
(below = (function* () { for (const f of $iter(self.figures)) { if (!($truth(f.at_least))) continue; yield f; } })());
return $b.tuple((function* () { for (const f of $iter(below)) { if (!(($truth(f.binding) || ((f.tension <= top) && (f.tension < Infinity))))) continue; yield f; } })());
}
$find_governing() {
const self = this; 
return alike__largest($bound(self, "required"), least_tension___tension);
}
get tension() {
const self = this; let top;

(top = self.highest);
if (((top != null) && (top.tension < $mul(self.governing.tension, $sub(1.0, 1e-09))))) {
return Infinity;
}
return self.governing.tension;
}
get level() {
const self = this; 
return ((self.tension <= self.given) ? "OK" : "ATTENTION");
}
get raise_to() {
const self = this; let none;

(none = $or((self.tension <= self.given), () => $or($math.isinf($bound(self, "tension")), () => self.elsewhere)));
return ($truth(none) ? null : self.tension);
}
$find_highest() {
const self = this; let above;

(above = [...(function* () { for (const f of $iter(self.figures)) { if (!(!$truth(f.at_least))) continue; yield f; } })()]);
return ($truth(above) ? alike__least(above, least_tension___tension) : null);
}
get standard() {
const self = this; 
return $b.next((function* () { for (const f of $iter(self.figures)) { if (!(($eq(f.name, "design_standard")))) continue; yield f; } })(), null);
}
}
$sig(LeastTension, ["figures", "given", "counterweight", "elsewhere"], false, {elsewhere: () => false});
class Row extends $Object {
}
$sig(Row, ["title", "values", "symbol", "note", "name", "level"], false, {symbol: () => "", note: () => "", name: () => "", level: () => null});
class Table extends $Object {
}
$sig(Table, ["title", "rows", "heads", "note", "name", "short", "brief"], false, {heads: () => $c0555, note: () => "", name: () => "", short: () => null, brief: () => ""});
class FrictionLaw extends $Object {
scaled(friction = 1.0, slip = 1.0) {
const self = this; 
return (($eq(friction, slip) && $eq(slip, 1.0)) ? self : self._scaled(friction, slip));
}
}
$sig(FrictionLaw, ["slip_includes"], false, {slip_includes: () => null});
class Constant extends FrictionLaw {
__post_init__() {
const self = this; let mu;
(mu = self.friction_coefficient);
base__check(simple___is_friction(mu));
}

compact() {
const self = this; 
return new CompactLaw(0, simple___edges($bound(self, "tested")), [self.friction_coefficient, 1.0, 0.0, 0.0]);
}
steepest_fall() {
const self = this; 
return 0.0;
}
_scaled(friction, slip) {
const self = this; return $replaced(self, new Map([["friction_coefficient", $mul(self.friction_coefficient, friction)]]));
}
}
$sig(Constant, ["slip_includes", "friction_coefficient", "tested"], false, {slip_includes: () => null, tested: () => null});
class PressurePower extends FrictionLaw {
__post_init__() {
const self = this; let mu, n, p;
([mu, p, n] = [self.friction_coefficient, self.reference_pressure, self.exponent]);
base__check(simple___is_friction(mu), [(0.0 < p && p < Infinity), "reference_pressure", ("" + $format(p, ("" + "g")) + " Pa"), ("" + "the pressure " + $str("must be positive and finite"))], [(0.0 <= n && n < 1.0), "exponent", ("" + $format(n, ("" + "g"))), "the exponent must lie in 0 <= n < 1"]);
}

compact() {
const self = this; let c;

(c = [self.friction_coefficient, self.reference_pressure, self.exponent, 0.0]);
return new CompactLaw(0, simple___edges($bound(self, "tested")), c);
}
steepest_fall() {
const self = this; 
return 0.0;
}
_scaled(friction, slip) {
const self = this; return $replaced(self, new Map([["friction_coefficient", $mul(self.friction_coefficient, friction)]]));
}
}
$sig(PressurePower, ["slip_includes", "friction_coefficient", "reference_pressure", "exponent", "tested"], false, {slip_includes: () => null, tested: () => null});
class ClassicalDrive extends $Object {
}
$sig(ClassicalDrive, ["design", "ratio", "wrap_factor", "slack_tension", "slipping_arc"], false, {});
class Input extends $Object {
text() {
const self = this; let digits;

if (((self.value == null) || $truth($b.isinstance(self.value, "str")))) {
return $b.str($bound(self, "value"));
}
if ($truth($math.isinf($bound(self, "value")))) {
return "rigid";
}
(digits = ((self.origin == null) ? 3 : 4));
return cell__quantity($bound(self, "value"), $bound(self, "dimension"), digits, $bound(self, "name"));
}
note(of) {
const self = this; let origin;

(origin = ((self.origin == null) ? "" : of.note($bound(self, "origin"))));
return $m.join("; ", (function* () { for (const part of $iter([origin, self.remark])) { if (!($truth(part))) continue; yield part; } })());
}
}
$sig(Input, ["group", "title", "value", "dimension", "symbol", "origin", "remark", "name"], false, {dimension: () => "number", symbol: () => "", origin: () => $c7015, remark: () => "", name: () => ""});
class Sources extends $Object {
$init() {
const self = this; (self._numbers = $map([]));
}
note(provenance) {
const self = this; let kind, number, origin;

(origin = $m.join(", ", (function* () { for (const part of $iter([provenance.source, provenance.date])) { if (!($truth(part))) continue; yield part; } })()));
if (!$truth(origin)) {
(kind = ((provenance.kind === "given") ? "" : $b.str($bound(provenance, "kind"))));
} else {
(number = $m.setdefault(self._numbers, origin, $add($b.len($bound(self, "_numbers")), 1)));
(kind = ("" + $str(provenance.kind_text) + " [" + $str(number) + "]"));
}
return $m.join(", ", (function* () { for (const part of $iter([kind, provenance.note])) { if (!($truth(part))) continue; yield part; } })());
}
number(text) {
const self = this; 
return ($truth(text) ? ("" + "[" + $str($m.setdefault(self._numbers, text, $add($b.len($bound(self, "_numbers")), 1))) + "]") : "");
}
listed() {
const self = this; 
return $b.tuple($bound(self, "_numbers"));
}
}
class TestedRange extends $Object {
__post_init__() {
const self = this; base__check([(0.0 < self.pressure_min && self.pressure_min <= self.pressure_max && self.pressure_max < Infinity), "pressure", ("" + $format(self.pressure_min, ("" + "g")) + " .. " + $format(self.pressure_max, ("" + "g")) + " Pa"), "the tested pressures must be positive, finite and in order"], [(0.0 < self.slip_max && self.slip_max < Infinity), "slip_max", ("" + $format(self.slip_max, ("" + "g")) + " m"), "the largest tested slip must be positive and finite"], [$or((self.slip_speed == null), () => (0.0 < self.slip_speed && self.slip_speed < Infinity)), "slip_speed", ("" + $str(self.slip_speed) + " m/s"), "the speed of slip in the tests must be positive and finite"]);
}
}
$sig(TestedRange, ["pressure_min", "pressure_max", "slip_max", "slip_speed"], false, {slip_speed: () => null});
class MeasuredTable extends FrictionLaw {
__post_init__() {
const self = this; let m, numbers;
(m = $b.len($bound(self, "slip")));
(numbers = [...$iter(self.slip), ...$iter(self.pressure), ...$iter((function* () { for (const row of $iter(self.values)) { for (const v of $iter(row)) { yield v; }} })())]);
base__check([$b.all($b.map($math.isfinite, numbers)), "values", "", "the table must hold finite numbers only"], [$and((m >= 2), () => ($eq($at(self.slip, 0), 0.0))), "slip", ("" + $str(m) + " slips"), "at least two slips, the first of them 0, are needed"], [table___ascending($bound(self, "slip")), "slip", "", "the slips must be in ascending order"], [$or($b.all((function* () { for (const [a, b] of $iter($b.pairwise($bound(self, "slip")))) { yield ($sub(b, a) >= 1e-09); } })()), () => !$truth(table___ascending($bound(self, "slip")))), "slip", "", "the slips must be at least 1 nm apart"], [!$truth($b.any((function* () { for (const slip of $iter(self.slip)) { yield (1000.0 < slip && slip < Infinity); } })())), "slip", ("" + $format($b.max($bound(self, "slip"), $k({default: 0.0})), ("" + "g")) + " m"), "the slips must be at most 1 km"], [$and($b.bool($bound(self, "pressure")), () => $and(table___ascending($bound(self, "pressure")), () => $b.all((function* () { for (const p of $iter(self.pressure)) { yield (p > 0); } })()))), "pressure", "", "the pressures must be positive and in ascending order"], [$and(($eq($b.len($bound(self, "values")), $b.len($bound(self, "pressure")))), () => $b.all((function* () { for (const row of $iter(self.values)) { yield ($eq($b.len(row), m)); } })())), "friction", "", ("" + "the table must have a row of " + $str(m) + " values for each of " + $str($b.len($bound(self, "pressure"))) + " pressures")], [$and($b.all((function* () { for (const row of $iter(self.values)) { for (const v of $iter($slice(row, null, 1))) { yield $or(($eq(v, 0.0)), () => (v >= 1e-06)); }} })()), () => $b.all((function* () { for (const row of $iter(self.values)) { for (const v of $iter($slice(row, 1, null))) { yield (v >= 1e-06); }} })())), "friction", "", ("" + "friction must be at least " + $format(1e-06, ("" + "g")) + " past slip 0, that or 0 at slip 0")], [($b.len(new Set((function* () { for (const row of $iter(self.values)) { if (!($truth(row))) continue; yield ($at(row, 0) > 0); } })())) <= 1), "friction", "", "friction at slip 0 must be 0 at every pressure or positive at every pressure"]);
}
get tested() {
const self = this; 
return new TestedRange($at(self.pressure, 0), $at(self.pressure, $neg(1)), $at(self.slip, $neg(1)));
}


_scaled(friction, slip) {
const self = this; let rows;
(rows = $b.tuple((function* () { for (const row of $iter(self.values)) { yield $b.tuple((function* () { for (const mu of $iter(row)) { yield $mul(mu, friction); } })()); } })()));
return $replaced(self, new Map([["slip", $b.tuple((function* () { for (const x of $iter(self.slip)) { yield $mul(x, slip); } })())], ["values", rows]]));
}
}
$sig(MeasuredTable, ["slip_includes", "slip", "pressure", "values"], false, {slip_includes: () => null});
class _Term extends $Tuple {
}
$sig(_Term, ["coefficient", "function", "power", "exponent"], false, {});
class Trend extends $Object {
__post_init__() {
const self = this; let n;
(n = $b.len($bound(self, "coefficients")));
base__check([($in(self.form, $c7f7c)), "form", self.form, ("" + "the form must be one of " + $str($m.join(", ", $c7f7c)))], [(1 <= n && n <= 4), "coefficients", $b.str(n), "one to four coefficients are needed"], [$b.all($b.map($math.isfinite, $bound(self, "coefficients"))), "coefficients", $b.str($bound(self, "coefficients")), "must be finite"], [($in(self.sign, [1, $neg(1)])), "sign", $b.str($bound(self, "sign")), "the sign must be 1 or -1"]);
}
at(pressure) {
const self = this; let c, exponential, logarithmic, v, y;

([logarithmic, exponential] = $at($c7f7c, self.form));
([v, y] = [($truth(logarithmic) ? $math.log(pressure) : pressure), 0.0]);
for (c of $iter($b.reversed($bound(self, "coefficients")))) {
(y = $add(c, $mul(y, v)));
}
return ($truth(exponential) ? $mul(self.sign, trend___exp(y)) : y);
}
times(factor) {
const self = this; let c;

(c = self.coefficients);
if (($in(self.form, ["power", "exponential"]))) {
return $replaced(self, new Map([["coefficients", [$add($at(c, 0), $math.log(factor)), ...$iter($slice(c, 1, null))]]]));
}
return $replaced(self, new Map([["coefficients", $b.tuple((function* () { for (const v of $iter(c)) { yield $mul(v, factor); } })())]]));
}
row() {
const self = this; let c, exponential, logarithmic;

([logarithmic, exponential] = $at($c7f7c, self.form));
(c = $add(self.coefficients, $mul([0.0], $sub(4, $b.len($bound(self, "coefficients"))))));
return [...$iter(c), $b.float(logarithmic), ($truth(exponential) ? $b.float($bound(self, "sign")) : 0.0)];
}
}
$sig(Trend, ["form", "coefficients", "sign"], false, {form: () => "polynomial", sign: () => 1});
class Piece extends $Object {
}
$sig(Piece, ["a", "b", "post_peak_slope", "residual_friction"], false, {post_peak_slope: () => $c07bd, residual_friction: () => $c07bd5});
class CoefficientPieces extends $Object {
__post_init__() {
const self = this; let n, problems;
(n = $b.len($bound(self, "pieces")));
base__check([(n >= 1), "pieces", $b.str(n), "at least one piece is needed"], [($eq($b.len($bound(self, "pressure")), $add(n, 1))), "pressure", coefficients___list($bound(self, "pressure"), "Pa"), ("" + "must have " + $str($add(n, 1)) + " pressures, the ends of " + $str(n) + " pieces")], [(0.0 < self.slip_unit && self.slip_unit < Infinity), "slip_unit", ("" + $format(self.slip_unit, ("" + "g")) + " m"), "the unit of slip must be positive and finite"], [$and($b.all((function* () { for (const [a, b] of $iter($b.zip($bound(self, "pressure"), $slice(self.pressure, 1, null), $k({strict: false})))) { yield (a < b); } })()), () => $b.all((function* () { for (const p of $iter(self.pressure)) { yield (0 < p && p < Infinity); } })())), "pressure", coefficients___list($bound(self, "pressure"), "Pa"), "the transition pressures must be positive, finite and in ascending order"]);
(problems = $or([...(function* () { for (const i of $iter($b.range(n))) { for (const p of $iter(self._piece_problems(i))) { yield p; }} })()], () => self._jumps()));
if ($truth(problems)) {
throw new InputError(problems);
}
}
_piece_problems(i) {
const self = this; let a, b, bad, high, key, low, piece, places, residual, slope, where, worst;
([low, high] = $slice(self.pressure, i, $add(i, 2)));
(places = [...(function* () { for (const k of $iter($b.range(101))) { yield $add(low, ($mul($sub(high, low), k) / 100.0)); } })()]);
(piece = $at(self.pieces, i));
(where = ("" + "between " + $format(low, ("" + "g")) + " and " + $format(high, ("" + "g")) + " Pa"));
(key = ("" + "pieces[" + $str($add(i, 1)) + "]"));
([a, b] = [[...(function* () { for (const p of $iter(places)) { yield piece.a.at(p); } })()], [...(function* () { for (const p of $iter(places)) { yield piece.b.at(p); } })()]]);
(slope = [...(function* () { for (const p of $iter(places)) { yield piece.post_peak_slope.at(p); } })()]);
(residual = [...(function* () { for (const p of $iter(places)) { yield piece.residual_friction.at(p); } })()]);
(bad = []);
if (!$truth($b.all((function* () { for (const v of $iter(a)) { yield $and($math.isfinite(v), () => (v < 0.0)); } })()))) {
(worst = $b.max([...(function* () { for (const v of $iter(a)) { if (!(($eq(v, v)))) continue; yield v; } })()], $k({default: NaN})));
$m.append(bad, new Problem(("" + "A must be negative " + $str(where) + ", else the law gives no positive friction"), undefined, undefined, ("" + $str(key) + ".a"), ("" + $format(worst, ("" + "g")) + " 1/m")));
} else {
if (!$truth($b.all((function* () { for (const [u, v] of $iter($b.zip(a, b, $k({strict: true})))) { yield $and((-700.0 <= $sub((v / u), 1.0) && $sub((v / u), 1.0) < 709.0), () => (1e-09 <= $mul($math.exp($sub((v / u), 1.0)), self.slip_unit) && $mul($math.exp($sub((v / u), 1.0)), self.slip_unit) <= 1000.0)); } })()))) {
$m.append(bad, new Problem(("" + "the slip at the peak exp(b/A - 1) must be 1 nm to 1 km " + $str(where)), undefined, undefined, ("" + $str(key) + ".b"), ("" + $format($at(b, 0), ("" + "g")) + " 1/m")));
}
}
if (!$truth($b.all((function* () { for (const v of $iter(slope)) { yield (v <= 0.0); } })()))) {
$m.append(bad, new Problem(("" + "the slope past the peak must be 0 or negative " + $str(where)), undefined, undefined, ("" + $str(key) + ".post_peak_slope"), ("" + $format($b.max(slope), ("" + "g")) + " 1/m")));
}
if (!$truth($b.all((function* () { for (const v of $iter(residual)) { yield (v >= 1e-06); } })()))) {
$m.append(bad, new Problem(("" + "residual friction must be at least " + $format(1e-06, ("" + "g")) + " " + $str(where)), undefined, undefined, ("" + $str(key) + ".residual_friction"), ("" + $format($b.min(residual), ("" + "g")))));
}
return bad;
}
_jumps() {
const self = this; let bad, high, i, low, name, p, u, v;
(bad = []);
for (i of $iter($b.range($sub($b.len($bound(self, "pieces")), 1)))) {
(p = $at(self.pressure, $add(i, 1)));
([low, high] = (function* () { for (const s of $iter($slice(self.pieces, i, $add(i, 2)))) { yield coefficients__peak_from_ab(s.a.at(p), s.b.at(p)); } })());
for ([name, u, v] of $iter([["peak friction", $at(low, 0), $at(high, 0)], ["peak slip", $at(low, 1), $at(high, 1)]])) {
if (($b.abs($sub((v / u), 1.0)) > self.continuity)) {
$m.append(bad, new Problem(("" + $str(name) + " jumps at the transition pressure " + $format(p, ("" + "g")) + " Pa; pieces must meet within " + $format($mul(100, self.continuity), ("" + "g")) + " %"), undefined, undefined, ("" + "pieces[" + $str($add(i, 2)) + "]"), ("" + $format(u, ("" + "g")) + " and " + $format(v, ("" + "g")))));
}
}
(bad = $add(bad, self._tail_jumps(i, p, low, high)));
}
return bad;
}
_tail_jumps(i, p, low, high) {
const self = this; let _, apart, friction, levels, lower, piece, slopes;

([levels, slopes] = [[], []]);
for ([piece, [friction, _]] of $iter($b.zip($slice(self.pieces, i, $add(i, 2)), [low, high], $k({strict: true})))) {
$m.append(levels, $b.min(piece.residual_friction.at(p), friction));
$m.append(slopes, (($at(levels, $neg(1)) < friction) ? piece.post_peak_slope.at(p) : 0.0));
}
(apart = ($mul($mul($b.abs($sub($at(slopes, 1), $at(slopes, 0))), self.slip_unit), $at(low, 1)) / $at(low, 0)));
(lower = ($truth($b.all(slopes)) ? ($mul($at(levels, 1), $at(low, 0)) / $mul($at(levels, 0), $at(high, 0))) : 1.0));
return [...(function* () { for (const [name, key, pair, unit, of, jump] of $iter([["the slope past the peak", "post_peak_slope", slopes, " 1/m", " of the peak friction over a peak slip", apart], ["residual friction", "residual_friction", levels, "", "", $b.abs($sub(lower, 1.0))]])) { if (!((jump > self.continuity))) continue; yield new Problem(("" + $str(name) + " jumps at the transition pressure " + $format(p, ("" + "g")) + " Pa; pieces must meet within " + $format($mul(100, self.continuity), ("" + "g")) + " %" + $str(of)), undefined, undefined, ("" + "pieces[" + $str($add(i, 2)) + "]." + $str(key)), ("" + $format($at(pair, 0), ("" + "g")) + " and " + $format($at(pair, 1), ("" + "g")) + $str(unit))); } })()];
}

scaled(friction, slip) {
const self = this; 
return $replaced(self, new Map([["slip_unit", $mul(self.slip_unit, slip)], ["pieces", $b.tuple((function* () { for (const piece of $iter(self.pieces)) { yield $replaced(piece, new Map([["a", piece.a.times(friction)], ["b", piece.b.times(friction)], ["post_peak_slope", piece.post_peak_slope.times((friction / slip))], ["residual_friction", piece.residual_friction.times(friction)]])); } })())]]));
}
}
$sig(CoefficientPieces, ["pressure", "pieces", "slip_unit", "continuity"], false, {slip_unit: () => 1.0, continuity: () => 0.02});
class PressureKnots extends $Object {
__post_init__() {
const self = this; let n;
(n = $b.len($bound(self, "pressure")));
base__check([(n >= 1), "pressure", $b.str(n), "at least one knot is needed"], ...$iter((function* () { for (const [name, values, optional] of $iter(self._columns())) { yield [$or(($eq($b.len(values), n)), () => $and(optional, () => !$truth(values))), name, ("" + $str($b.len(values)) + " values"), ("" + "must have " + $str(n) + " values, one for each pressure")]; } })()), ...$iter((function* () { for (const [name, values, _] of $iter(self._columns())) { yield [$b.all($b.map($math.isfinite, values)), name, $b.str(values), "must be finite numbers"]; } })()), [$and($b.all((function* () { for (const [a, b] of $iter($b.zip($bound(self, "pressure"), $slice(self.pressure, 1, null), $k({strict: false})))) { yield (a < b); } })()), () => $b.all((function* () { for (const p of $iter(self.pressure)) { yield (p > 0); } })())), "pressure", coefficients___list($bound(self, "pressure"), "Pa"), "the pressures of the knots must be positive and in ascending order"], [$b.all((function* () { for (const v of $iter(self.peak_friction)) { yield (v >= 1e-06); } })()), "peak_friction", coefficients___list($bound(self, "peak_friction")), ("" + "friction must be at least " + $format(1e-06, ("" + "g")))], [$b.all((function* () { for (const v of $iter(self.peak_slip)) { yield (1e-09 <= v && v <= 1000.0); } })()), "peak_slip", coefficients___list($bound(self, "peak_slip"), "m"), "slip at the peak must be 1 nm to 1 km"], [$b.all((function* () { for (const v of $iter(self.post_peak_slope)) { yield (v <= 0); } })()), "post_peak_slope", coefficients___list($bound(self, "post_peak_slope"), "1/m"), "the slope past the peak must be 0 or negative"], [$b.all((function* () { for (const v of $iter(self.residual_friction)) { yield (v >= 1e-06); } })()), "residual_friction", coefficients___list($bound(self, "residual_friction")), ("" + "residual friction must be at least " + $format(1e-06, ("" + "g")))]);
}
_columns() {
const self = this; return [["pressure", self.pressure, false], ["peak_friction", self.peak_friction, false], ["peak_slip", self.peak_slip, false], ["post_peak_slope", self.post_peak_slope, true], ["residual_friction", self.residual_friction, true]];
}
scaled(friction, slip) {
const self = this; 
return $replaced(self, new Map([["peak_friction", $b.tuple((function* () { for (const v of $iter(self.peak_friction)) { yield $mul(v, friction); } })())], ["peak_slip", $b.tuple((function* () { for (const v of $iter(self.peak_slip)) { yield $mul(v, slip); } })())], ["post_peak_slope", $b.tuple((function* () { for (const v of $iter(self.post_peak_slope)) { yield ($mul(v, friction) / slip); } })())], ["residual_friction", $b.tuple((function* () { for (const v of $iter(self.residual_friction)) { yield $mul(v, friction); } })())]]));
}

}
$sig(PressureKnots, ["pressure", "peak_friction", "peak_slip", "post_peak_slope", "residual_friction"], false, {post_peak_slope: () => [], residual_friction: () => []});
class IntegralLog extends FrictionLaw {
__post_init__() {
const self = this; let p, t;
if (((self.tested == null) || ($b.len($bound(self.coefficients, "pressure")) < 2))) {
return null;
}
(p = self.coefficients.pressure);
(t = self.tested);
base__check([$and(($b.abs($sub((t.pressure_min / $at(p, 0)), 1.0)) < 1e-06), () => ($b.abs($sub((t.pressure_max / $at(p, $neg(1))), 1.0)) < 1e-06)), "tested", ("" + $format(t.pressure_min, ("" + "g")) + " .. " + $format(t.pressure_max, ("" + "g")) + " Pa"), ("" + "the tested pressures must be the ends of the law, " + $format($at(p, 0), ("" + "g")) + " .. " + $format($at(p, $neg(1)), ("" + "g")) + " Pa")]);
}



_scaled(friction, slip) {
const self = this; return $replaced(self, new Map([["coefficients", self.coefficients.scaled(friction, slip)]]));
}

}
$sig(IntegralLog, ["slip_includes", "coefficients", "tested"], false, {slip_includes: () => null, tested: () => null});
class Factors extends $Object {
__post_init__() {
const self = this; limits__raise_all([...$iter(factors___outside("slip_speed", $bound(self, "slip_speed"), $bound(self, "by_slip_speed"), "speed")), ...$iter(factors___outside("temperature", $bound(self, "temperature"), $bound(self, "by_temperature"), "temperature"))]);
}
get fastest() {
const self = this; let table;

(table = self.by_slip_speed);
return ((table == null) ? null : $or(self.slip_speed, () => $at(table.at, $neg(1))));
}
get of_slip_speed() {
const self = this; let fastest, table;

([table, fastest] = [self.by_slip_speed, self.fastest]);
return (((table == null) || (fastest == null)) ? 1.0 : table.least($at(table.at, 0), fastest));
}
get of_temperature() {
const self = this; let table;

(table = self.by_temperature);
if ((table == null)) {
return 1.0;
}
if ((self.temperature != null)) {
return table.least($bound(self, "temperature"), $bound(self, "temperature"));
}
return $b.min($bound(table, "factor"));
}
get used() {
const self = this; let fastest, law, tested;

(law = self.law.scaled($mul(self.of_slip_speed, self.of_temperature)));
([tested, fastest] = [law.tested, self.fastest]);
if (((tested == null) || (fastest == null) || $truth($b.isinstance(law, MeasuredTable)))) {
return law;
}
return $replaced(law, new Map([["tested", $replaced(tested, new Map([["slip_speed", fastest]]))]]));
}
get sources() {
const self = this; let tables;

(tables = $map([["slip_speed_factor", self.by_slip_speed], ["temperature_factor", self.by_temperature]]));
return $map([...(function* () { for (const [key, table] of $iter($m.items(tables))) { if (!((table != null))) continue; yield [key, table.source]; } })()]);
}
}
$sig(Factors, ["law", "by_slip_speed", "by_temperature", "slip_speed", "temperature"], false, {by_slip_speed: () => null, by_temperature: () => null, slip_speed: () => null, temperature: () => null});
class Lagging extends Viewable {
__post_init__() {
const self = this; let message, problems;
(problems = $add(limits__name_problems("name", $bound(self, "name")), limits__name_problems("condition", $bound(self, "condition"))));
(problems = $add(problems, limits__limit_problems(self, $bound(self, "LIMITS"))));
if (($truth(self.surface) && (!$in(self.surface, $c504b)))) {
(message = ("" + "must be one of " + $str($m.join(", ", $c504b))));
$m.append(problems, new Problem(message, undefined, undefined, "surface", $shown($bound(self, "surface"))));
}
(problems = $add(problems, uncertain__uncertainty_problems($bound(self, "uncertainty"), $c5832)));
if ((self.fit != null)) {
(problems = $add(problems, [...(function* () { for (const key of $iter(["friction", "slip"])) { if (!(($in(key, self.uncertainty)))) continue; yield new Problem("contradicts the fit of the law, which has an interval", "Remove one of them.", undefined, ("" + "uncertainty." + $str(key))); } })()]));
}
limits__raise_all(problems);
}
get contact_fraction() {
const self = this; let block;

(block = $or(self.block, () => self.replaced_block));
return ((block == null) ? 1.0 : block.contact_fraction);
}
get shear_compliance() {
const self = this; 
if (($in("lagging shear", $or(self.law.slip_includes, () => [])))) {
return 0.0;
}
return (self.thickness / self.shear_modulus);
}
source_of(part) {
const self = this; 
return $m.get(self.sources, part, $bound(self, "provenance"));
}
}
$sig(Lagging, ["name", "law", "thickness", "shear_modulus", "compression_modulus", "title", "condition", "surface", "elastic_modulus", "wear_coefficient", "belt_energy_share", "bond_strength", "fatigue_limit", "cost", "fit", "factors", "condition_factors", "block", "replaced_block", "uncertainty", "provenance", "sources", "scaled_by", "notes", "description"], false, {thickness: () => 0.0, shear_modulus: () => Infinity, compression_modulus: () => Infinity, title: () => "", condition: () => "dry", surface: () => "", elastic_modulus: () => null, wear_coefficient: () => null, belt_energy_share: () => null, bond_strength: () => null, fatigue_limit: () => null, cost: () => null, fit: () => null, factors: () => null, condition_factors: () => new Map(), block: () => null, replaced_block: () => null, uncertainty: () => new Map(), provenance: () => new Provenance(), sources: () => new Map(), scaled_by: () => null, notes: () => [], description: () => ""});
class LoadGiven extends $Tuple {
}
$sig(LoadGiven, ["entry_tension", "exit_tension", "effective_tension", "torque", "power"], false, {entry_tension: () => null, exit_tension: () => null, effective_tension: () => null, torque: () => null, power: () => null});
class DrumAt extends $Tuple {
}
$sig(DrumAt, ["diameter", "speed"], false, {});
class Pair extends $Tuple {
}
$sig(Pair, ["entry", "exit"], false, {});
class TorqueFollower extends $Object {
__post_init__() {
const self = this; limits__raise_all(limits__limit_problems(self, $bound(self, "LIMITS")));
}
}
$sig(TorqueFollower, ["master", "ratio"], false, {ratio: () => 1.0});
class RunsGain extends $Tuple {
}
$sig(RunsGain, ["base", "case"], false, {base: () => 0.0, case: () => 0.0});
class BehindTakeUp extends $Tuple {
}
$sig(BehindTakeUp, ["share", "behind", "runs"], false, {});
class Growth extends $Tuple {
}
$sig(Growth, ["tight", "slack"], false, {});
class OfBelt extends $Dict {
}
class Description extends $Tuple {
}
$sig(Description, ["entry_tension", "exit_tension", "diameter", "wrap_angle", "width", "axial_stiffness", "thickness", "shear_modulus", "compression_modulus", "overrun", "recovery", "belt_speed", "wear_coefficient", "shear_compliance", "pitch_offset", "centrifugal"], false, {});
class Load extends $Tuple {
}
$sig(Load, ["entry_tension", "exit_tension", "creep_limit", "pressure_min", "pressure_max", "slip_max", "steepest_fall"], false, {});
class DataLine extends $Tuple {
}
$sig(DataLine, ["items", "text"], false, {});
class CompactLaw extends $Tuple {
}
$sig(CompactLaw, ["kind", "edges", "coefficients", "slips", "onset_compliance"], false, {slips: () => [], onset_compliance: () => 0.0});
class TakeUp extends $Object {
__post_init__() {
const self = this; let given, message, problems, remedy;
(problems = limits__limit_problems(self, $bound(self, "LIMITS")));
(problems = $add(problems, criteria__choice_problems(self, $map([["kind", ["", ...$iter($c9cf4)]]]))));
if (($truth(self.after) && $truth(self.fixed))) {
(message = "a fixed take-up needs no place");
(remedy = "Leave it out, or correct the kind.");
(given = $shown($bound(self, "after")));
$m.append(problems, new Problem(message, remedy, undefined, "after", given));
}
limits__raise_all(problems);
}
place_among(pulleys) {
const self = this; 
return ($truth(self.after) ? $m.index(pulleys, $bound(self, "after")) : $neg(1));
}
place_problems(pulleys) {
const self = this; let given, remedy;

if ((!$truth(self.after) || ($in(self.after, pulleys)))) {
return [];
}
([given, remedy] = [$shown($bound(self, "after")), errors__name_remedy($bound(self, "after"), pulleys)]);
return [new Problem("no such pulley", remedy, undefined, "take_up.after", given)];
}
get fixed() {
const self = this; 
return ($eq(self.kind, "fixed"));
}
counterweight(tension) {
const self = this; 
return ($mul(self.sheave_ratio, tension) / 9.80665);
}
}
$sig(TakeUp, ["kind", "sheave_ratio", "after"], false, {kind: () => "", sheave_ratio: () => 2.0, after: () => ""});
class DesignStandard extends $Object {
__post_init__() {
const self = this; let given, message, problems, remedy, words;
(words = $map([["name", ["", ...$iter($c6e6b)]], ["condition", ["", ...$iter($ceb6d)]]]));
(problems = $add(limits__limit_problems(self, $bound(self, "LIMITS")), criteria__choice_problems(self, words)));
if ((!$eq(($eq(self.name, "own")), (self.friction != null)))) {
(given = ((self.friction == null) ? "" : ("" + $format(self.friction, ("" + "g")))));
(message = "missing for a standard of your own");
(remedy = "Write friction = 0.30 beside it.");
if ($truth(given)) {
([message, remedy] = ["only a standard of your own has one", "Write name = \"own\"."]);
}
$m.append(problems, new Problem(message, remedy, undefined, "friction", given));
}
if ((($eq(self.name, "none")) && $truth(self.binding))) {
(message = "no standard was chosen that could bind");
$m.append(problems, new Problem(message, undefined, undefined, "binding", "true"));
}
limits__raise_all(problems);
}
}
$sig(DesignStandard, ["name", "condition", "friction", "start_factor", "binding"], false, {name: () => "", condition: () => "", friction: () => null, start_factor: () => 1.0, binding: () => false});
class SafetyFactors extends $Object {
__post_init__() {
const self = this; limits__raise_all(limits__limit_problems(self, $bound(self, "LIMITS")));
}
of(kind) {
const self = this; 
return $b.float($b.getattr(self, kind));
}
}
$sig(SafetyFactors, ["running", "starting", "braking", "source"], false, {running: () => 1.25, starting: () => 1.1, braking: () => 1.1, source: () => ""});
class Kind extends $Object {
built(value, report, more = new Map()) {
const self = this; 
return value;
}
}
class tables$Table extends Kind {
get _fields() { return $kept(this, "_fields", this.$find__fields()); }
$init(title, ...entries) {
const self = this; const {of: of = null, on_one_line: on_one_line = false, misplaced: misplaced = null} = $named(entries);
([self.title, self.of, self.on_one_line] = [title, of, on_one_line]);
(self.misplaced = misplaced);
(self.entries = $b.tuple((function* () { for (const e of $iter(entries)) { yield ((e.kind === $c843e) ? $replaced(e, new Map([["kind", tables___kind_of(of, $bound(e, "attribute"))]])) : e); } })()));
(self._known = $map([...(function* () { for (const entry of $iter(self.entries)) { yield [entry.key, entry]; } })()]));
}
read(raw, place, report) {
const self = this; let entry, given, key, known, misspelt, record, unknown, value;

if (!$truth($b.isinstance(raw, "dict"))) {
report.add(place, "must be a table", "Write its keys below its name in [ ].", raw);
return $ca9ba;
}
(given = self._renamed(raw, place, report));
(known = self._known);
(record = new Record($map([]), place, given));
(unknown = [...(function* () { for (const key of $iter(given)) { if (!((!$in(key, known)))) continue; yield key; } })()]);
if ((self.misplaced != null)) {
(unknown = self._without_misplaced(unknown, record, report));
}
for (key of $iter(unknown)) {
$m.update(record.faulty, self._report_unknown(key, given, place, report));
}
(misspelt = $b.set($bound(record, "faulty")));
for ([key, entry] of $iter($m.items(known))) {
if (($in(key, given))) {
(value = entry.kind.read($at(given, key), [...$iter(place), key], report));
if (!$truth(tables___sound(value))) {
record.faulty.add(key);
}
if ((value !== $ca9ba)) {
$put(record, key, value);
}
} else {
if (($truth(entry.required) && !($truth(entry.unless) && ($in(entry.unless, given))))) {
record.faulty.add(key);
if ($truth($m.isdisjoint(misspelt, [key, entry.unless]))) {
report.add([...$iter(place), key], "missing", tables__missing_remedy(entry));
}
}
}
}
return record;
}
built(value, report, more = new Map()) {
const self = this; let made, names, record, values;

if ((!$truth($b.isinstance(value, Record)) || !$truth(value.sound()) || (self.of == null))) {
return null;
}
([made, record] = [self.of, value]);
(values = $map([...(function* () { for (const e of $iter(self.entries)) { if (!((($in(e.key, record)) && ($in(e.attribute, self._fields)) && !$truth($b.isinstance($at(record, e.key), "dict"))))) continue; yield [e.attribute, tables___frozen($at(record, e.key))]; } })()]));
(names = $map([...(function* () { for (const e of $iter(self.entries)) { yield [e.attribute, e.key]; } })()]));
return report.tried((() => $call(made, [], [...$map([...values, ...more])])), $bound(record, "place"), $bound(record, "raw"), names);
}
_report_unknown(key, given, place, report) {
const self = this; let close, meant, remedy;

if ($truth(report.full)) {
report.add([...$iter(place), key], "unknown key");
return [];
}
(close = errors__near(key, [...(function* () { for (const k of $iter(self._known)) { if (!((!$in(k, given)))) continue; yield k; } })()], 1));
([remedy, meant] = [tables__unknown_key_remedy(key, $bound(self, "_known")), ($truth(close) ? $at(close, 0) : "")]);
$method(report, "add", [[...$iter(place), key], "unknown key", remedy], [["code", "unknown_key"], ["meant", meant]]);
return close;
}
_without_misplaced(unknown, record, report) {
const self = this; let of, remedy, there;

(of = self.misplaced);
(there = ((of == null) ? [] : [...(function* () { for (const key of $iter(unknown)) { if (!(($in(key, of.keys)))) continue; yield key; } })()]));
if (((of != null) && $truth(there))) {
record.faulty.add($bound(of, "owner"));
if ($truth($b.all((function* () { for (const problem of $iter(report.problems)) { yield (!$eq(problem.message, of.message)); } })()))) {
(remedy = $m.replace(of.remedy, "{key}", $at(there, 0)));
report.add([...$iter(record.place), $at(there, 0)], $bound(of, "message"), remedy);
}
}
return [...(function* () { for (const key of $iter(unknown)) { if (!((!$in(key, there)))) continue; yield key; } })()];
}
_renamed(raw, place, report) {
const self = this; let entry, given, message, value;
(given = $b.dict(raw));
for (entry of $iter(self.entries)) {
if ((!$truth(entry.alias) || (!$in(entry.alias, given)))) {
continue;
}
(value = $m.pop(given, $bound(entry, "alias")));
if (($in(entry.key, given))) {
(message = ("" + "means the same as " + $str(entry.key) + ", which is also there"));
report.add([...$iter(place), entry.alias], message, "Remove one of them.", value);
} else {
$put(given, entry.key, value);
}
}
return given;
}
$find__fields() {
const self = this; 
return ($truth(self.of) ? $b.frozenset((function* () { for (const f of $iter($fields(self.of))) { yield f.name; } })()) : $b.frozenset());
}
}
class Entry extends $Object {
__post_init__() {
const self = this; (self.title = $or(self.title, () => $m.capitalize($m.replace(self.key, "_", " "))));
(self.attribute = $or(self.attribute, () => self.key));
}
}
$sig(Entry, ["key", "meaning", "kind", "title", "required", "alias", "example", "attribute", "unless", "stated"], false, {meaning: () => "", kind: () => $c843e, title: () => "", required: () => false, alias: () => "", example: () => "", attribute: () => "", unless: () => "", stated: () => false});
class Name extends Kind {
read(raw, place, report) {
const self = this; let value;

(value = new Text($bound(self, "longest")).read(raw, place, report));
if (((value !== $ca9ba) && !$truth($m.strip(value)))) {
report.add(place, "must not be empty", "Write a name.", raw);
return $ca9ba;
}
return value;
}
}
$sig(Name, ["longest"], false, {longest: () => 60});
class Text extends Kind {
read(raw, place, report) {
const self = this; 
if (!$truth($b.isinstance(raw, "str"))) {
report.add(place, "must be text", "Put it in quotes.", raw);
} else {
if (($b.len(raw) > self.longest)) {
report.add(place, ("" + "longer than " + $str(self.longest) + " characters"), "Shorten it.", raw);
} else {
if (!$truth($m.isprintable(($truth(self.lines) ? $m.translate(raw, $ca8ba) : raw)))) {
report.add(place, "contains characters that cannot be printed", "Remove them.", raw);
} else {
return raw;
}
}
}
return $ca9ba;
}
}
$sig(Text, ["longest", "lines"], false, {longest: () => 200, lines: () => false});
class Quantity extends Kind {
read(raw, place, report) {
const self = this; let refusal, value;

try {
(value = parse__parse_quantity(raw, $bound(self, "dimension")));
} catch ($error) {
if ($error instanceof InputError) {
report.tried((() => parse__parse_quantity(raw, $bound(self, "dimension"), self.example())), place, raw);
return $ca9ba;
} else throw $error;
}
(refusal = ($truth(self.limit) ? self.limit.refusal(value) : ""));
if ($truth(refusal)) {
$method(report, "add", [place, refusal], [["value", raw]]);
return $ca9ba;
}
return value;
}
example() {
const self = this; let factor, number, scaled, text, unit;

(text = $at($c22c8, self.dimension).example);
([number, unit] = numbers__split_number(text));
for (factor of $iter($cdade)) {
(scaled = $m.strip(("" + $format($mul(number, $b.Decimal(factor)).normalize(), ("" + "f")) + " " + $str(unit))));
if (($truth(self.limit) && !$truth(self.limit.refusal(parse__parse_quantity(scaled, $bound(self, "dimension")))))) {
return scaled;
}
}
return text;
}
}
$sig(Quantity, ["dimension", "limit"], false, {limit: () => null});
class Limit extends $Object {
__str__() {
const self = this; let least;

(least = self._shown($bound(self, "least")));
if (($eq(self.most, Infinity))) {
return ($truth(self.open) ? ("" + "more than " + $str(least)) : ("" + "at least " + $str(least)));
}
if (($eq(self.least, $neg(Infinity)))) {
return ("" + "at most " + $str(self._shown($bound(self, "most"))));
}
if ($truth(self.open)) {
return ("" + "more than " + $str(least) + " and at most " + $str(self._shown($bound(self, "most"))));
}
return ("" + "between " + $str(least) + " and " + $str(self._shown($bound(self, "most"))));
}
_shown(bound) {
const self = this; return display__display(bound, $bound(self, "dimension"), undefined, 3);
}
refusal(value) {
const self = this; let unit;

if (!$truth(isNumber(value))) {
(unit = $at($c22c8, self.dimension).si_unit);
return ($truth(unit) ? ("" + "must be a number [" + $str(unit) + "]") : "must be a number");
}
if (($truth($math.isnan(value)) || ($truth($math.isinf(value)) && !($truth(self.rigid) && (value > 0))))) {
return "must be finite";
}
if ((!(self.least <= value && value <= self.most) || ($truth(self.open) && ($eq(value, self.least))))) {
return ("" + "must be " + $str(self));
}
return "";
}
}
$sig(Limit, ["dimension", "least", "most", "open", "rigid"], false, {least: () => 0.0, most: () => Infinity, open: () => false, rigid: () => false});
class WordOr extends Kind {
read(raw, place, report) {
const self = this; 
return (($eq(raw, self.word)) ? self.meaning : self.kind.read(raw, place, report));
}
}
$sig(WordOr, ["word", "kind", "meaning"], false, {meaning: () => null});
class Elongation extends Kind {
read(raw, place, report) {
const self = this; let found, message, of, remedy;

(found = ($truth($b.isinstance(raw, "str")) ? $m.fullmatch($c8c06, $m.replace($m.strip(raw), ",", ".")) : null));
(remedy = "Write for example \"1.5 % at 10 %\".");
if ((found == null)) {
report.add(place, "must be an elongation at a share of the strength", remedy, raw);
return $ca9ba;
}
try {
(of = new ElongationAt(...$iter((function* () { for (const n of $iter([1, 2])) { yield parse__parse_quantity(("" + $str($at(found, n)) + " %"), "number"); } })())));
} catch ($error) {
if ($error instanceof InputError) {
report.add(place, "must be an elongation at a share of the strength", remedy, raw);
return $ca9ba;
} else throw $error;
}
if (!((0.0 < of.strain && of.strain <= 0.2) && (0.0 < of.share && of.share <= 1.0))) {
(message = ("" + "must be above 0 %, at most " + $format($mul(100.0, 0.2), ("" + "g")) + " % at 100 %"));
report.add(place, message, remedy, raw);
return $ca9ba;
}
return of;
}
}
$sig(Elongation, [], false, {});
class Choice extends Kind {
read(raw, place, report) {
const self = this; let message, remedy;

if (($truth($b.isinstance(raw, "str")) && ($in(raw, self.options)))) {
return raw;
}
if (($truth($b.isinstance(raw, "str")) && ($in(raw, self.others)))) {
return $at(self.others, raw);
}
(message = ("" + "must be one of " + $str(errors__format_names($bound(self, "options")))));
(remedy = ($truth(report.full) ? "" : errors__nearest(raw, $bound(self, "options"), 1)));
report.add(place, message, remedy, raw);
return $ca9ba;
}
}
$sig(Choice, ["options", "others"], false, {others: () => new Map()});
class Rows extends Kind {
read(raw, place, report) {
const self = this; let count, labels, name;

if (($truth($b.isinstance(raw, "dict")) && $truth(place))) {
(name = problems__place_text(place));
report.add(place, "must be an array of tables", ("" + "Write [[" + $str(name) + "]] for [" + $str(name) + "]."));
return $ca9ba;
}
if (!$truth($b.isinstance(raw, "list"))) {
report.add(place, "must be an array", "Put it in [ ], as the examples show.", raw);
return $ca9ba;
}
if (!(self.least <= $b.len(raw) && $b.len(raw) <= self.most)) {
(count = ($truth(self.least) ? ("" + $str(self.least) + " to " + $str(self.most)) : ("" + "at most " + $str(self.most))));
$method(report, "add", [place, ("" + "must have " + $str(count) + " entries")], [["value", $b.len(raw)]]);
return $ca9ba;
}
(labels = kinds__table_labels(raw));
return [...(function* () { for (const [item, label] of $iter($b.zip(raw, labels, $k({strict: true})))) { yield self.kind.read(item, [...$iter(place), label], report); } })()];
}
}
$sig(Rows, ["kind", "least", "most"], false, {least: () => 0, most: () => 1000});
class Percent extends Quantity {
read(raw, place, report) {
const self = this; let found, message, text;

(text = $m.strip($m.replace($b.str(raw), ",", ".")));
if (($truth(text) && !$truth($m.strip(text, "+-.0123456789")))) {
report.add(place, "must be a percentage", ("" + "Write \"" + $str(text) + " %\"."), raw);
return $ca9ba;
}
(found = super.read(raw, place, new Report()));
if ((found === $ca9ba)) {
(message = ("" + "must be a percentage from 0 % to " + $format($mul(100.0, self.most), ("" + "g")) + " %"));
report.add(place, message, "Write for example \"0.5 %\".", raw);
}
return found;
}
}
$sig(Percent, ["dimension", "limit"], false, {limit: () => null});
class ByName extends Kind {
read(raw, place, report) {
const self = this; 
if (!$truth($b.isinstance(raw, "dict"))) {
report.add(place, "must be a table", ("" + "Write [" + $str($at(place, $neg(1))) + ".NAME]."), raw);
return $ca9ba;
}
if (($b.len(raw) > self.most)) {
$method(report, "add", [place, ("" + "must have at most " + $str(self.most) + " entries")], [["value", $b.len(raw)]]);
return $ca9ba;
}
return $map([...(function* () { for (const [name, item] of $iter($m.items(raw))) { if (!((new Name().read(name, [...$iter(place), name], report) !== $ca9ba))) continue; yield [name, self.kind.read(item, [...$iter(place), name], report)]; } })()]);
}
}
$sig(ByName, ["kind", "most"], false, {most: () => 200});
class _Nothing extends $Object {
}
class DimensionText extends $Tuple {
}
$sig(DimensionText, ["si_unit", "name", "example"], false, {});
class Definition extends $Tuple {
}
$sig(Definition, ["names", "factor", "unit", "zero"], false, {zero: () => $ce5b4b});
class Usual extends $Tuple {
}
$sig(Usual, ["value", "least", "most"], false, {});
class Cords extends $Tuple {
}
$sig(Cords, ["diameter", "pitch", "source"], false, {});
class Belt extends $Object {
__post_init__() {
const self = this; let problems;
(problems = $add(limits__name_problems("name", $bound(self, "name")), limits__limit_problems(self, $bound(self, "LIMITS"))));
(problems = $add(problems, belt_modulus__measurement_problems($bound(self, "modulus_test"), $bound(self, "modulus_loads"))));
(problems = $add(problems, uncertain__uncertainty_problems($bound(self, "uncertainty"), $cc3f6)));
limits__raise_all($or(problems, () => $or(self._cord_problems(), () => self._layer_problems())));
}
_cord_problems() {
const self = this; let carcass, cord, diameter, message, pitch, remedy, value;

([diameter, pitch, carcass] = [self.cord_diameter, self.cord_pitch, self.carcass]);
if (((diameter != null) && (carcass != null) && ($b.abs($sub(diameter, carcass)) > 1e-06))) {
(message = ("" + "must equal the carcass " + $str(display__display(carcass, "length"))));
([value, remedy] = [display__display(diameter, "length"), "Leave one of them out."]);
return [new Problem(message, remedy, undefined, "cord_diameter", value)];
}
(cord = self.cord);
if ((pitch == null)) {
return [];
}
if ((cord == null)) {
(remedy = "Write cord_diameter = \"5.6 mm\", or leave cord_pitch out.");
return [new Problem("needs cord_diameter", remedy, undefined, "cord_pitch")];
}
if ((pitch <= cord)) {
(message = ("" + "must be more than the cord diameter " + $str(display__display(cord, "length"))));
([value, remedy] = [display__display(pitch, "length"), "Give the distance between cord axes."]);
return [new Problem(message, remedy, undefined, "cord_pitch", value)];
}
return [];
}
_layer_problems() {
const self = this; let key, known, layers, least, message, of, remedy, rounding, sign, thin, total, value, whole;

(of = $merged($map([...(function* () { for (const key of $iter($c2d22)) { yield [key, $b.getattr(self, key)]; } })()]), $map([["carcass", self.cord]])));
(known = $map([...(function* () { for (const [key, value] of $iter($m.items(of))) { if (!((value != null))) continue; yield [key, value]; } })()]));
([total, whole, layers] = [$b.sum($m.values(known)), self.thickness, $m.join(" + ", known)]);
if ((whole == null)) {
if ((total <= 0.06)) {
return [];
}
(message = ("" + $str(layers) + " must be at most " + $str(display__display(0.06, "length"))));
([key, value, remedy] = [$b.next($b.iter(known), "thickness"), total, "Check their units."]);
} else {
([key, value, rounding] = ["thickness", whole, $mul(1e-09, whole)]);
([least, sign] = ((self.cord != null) ? ["at least", 1.0] : ["more than", $neg(1.0)]));
(thin = $and(($eq($b.len(known), $b.len($c2d22))), () => (total < $mul(0.98, whole))));
if (((total <= $add(whole, $mul(sign, rounding))) && !$truth(thin))) {
return [];
}
(message = ("" + "must be " + $str(($truth(thin) ? "at most" : least)) + " " + $str(layers) + " = " + $str(display__display(total, "length"))));
(remedy = ($truth(thin) ? "Leave one out." : "Correct or omit it."));
}
return [new Problem(message, remedy, undefined, key, display__display(value, "length"))];
}
get is_uncertain() {
const self = this; let by_name;

(by_name = $or((self.modulus_ends != null), () => (self.carcass_ends != null)));
return $or(by_name, () => ($b.len($bound(self, "uncertainty")) > 0));
}
get cord() {
const self = this; 
return ((self.cord_diameter == null) ? self.carcass : self.cord_diameter);
}
source_of(part) {
const self = this; 
return $m.get(self.sources, part, $bound(self, "provenance"));
}
get breaking_strength() {
const self = this; let bare, found, told;

(found = $m.search($c9234, $m.upper($m.strip(self.name))));
if (((self.strength != null) || (found == null) || ($in("PIW", $m.upper(self.name))))) {
return self.strength;
}
(told = $b.float($at(found, 1)));
(bare = $m.startswith($m.strip(self.name), $at(found, 1)));
if (($truth(bare) && (self.rating != null) && ($b.abs($sub((self.rating / $mul(told, 175.12683524647636)), 1.0)) < 0.02))) {
return null;
}
return $mul(1000.0, told);
}
get axial_stiffness() {
const self = this; 
return $mul(self.modulus, self.width);
}
}
$sig(Belt, ["name", "width", "modulus", "rating", "strength", "speed", "kind", "momentary_factor", "least_pulley_diameter", "largest_wrap_pressure", "in_plane_shear_stiffness", "pulley_cover", "carry_cover", "carcass", "thickness", "cover_shear_modulus", "cord_diameter", "cord_pitch", "mass", "modulus_test", "modulus_loads", "modulus_ends", "carcass_ends", "uncertainty", "provenance", "sources"], false, {rating: () => null, strength: () => null, speed: () => null, kind: () => "", momentary_factor: () => null, least_pulley_diameter: () => null, largest_wrap_pressure: () => null, in_plane_shear_stiffness: () => null, pulley_cover: () => null, carry_cover: () => null, carcass: () => null, thickness: () => null, cover_shear_modulus: () => null, cord_diameter: () => null, cord_pitch: () => null, mass: () => null, modulus_test: () => "", modulus_loads: () => null, modulus_ends: () => null, carcass_ends: () => null, uncertainty: () => new Map(), provenance: () => new Provenance(), sources: () => new Map()});
class TextOr extends Kind {
read(raw, place, report) {
const self = this; 
return ($truth($b.isinstance(raw, "dict")) ? self.table : self.text).read(raw, place, report);
}
}
$sig(TextOr, ["text", "table"], false, {});
class Flag extends Kind {
read(raw, place, report) {
const self = this; 
if ($truth($b.isinstance(raw, "bool"))) {
return raw;
}
report.add(place, "must be true or false", "Write it without quotes.", raw);
return $ca9ba;
}
}
$sig(Flag, [], false, {});
class Across extends $Object {
__post_init__() {
const self = this; let key, least, message, problems, profile;
(problems = limits__limit_problems(self, $bound(self, "LIMITS")));
if (!(4 <= self.strips && self.strips <= 128)) {
(message = ("" + "must be a whole number from " + $str(4) + " to " + $str(128)));
$m.append(problems, new Problem(message, undefined, undefined, "strips", $b.str($bound(self, "strips"))));
}
for (key of $iter(["worn_depth", "build_up"])) {
(profile = $b.getattr(self, key));
if (((profile != null) && ($b.min([...$iter(profile.value), profile.crown]) < 0.0))) {
(least = display__display($b.min([...$iter(profile.value), profile.crown]), "length"));
(message = "must not be negative");
$m.append(problems, new Problem(message, undefined, undefined, key, least));
}
}
limits__raise_all(problems);
}
profiles() {
const self = this; let found;

(found = $map([...(function* () { for (const f of $iter($fields(self))) { yield [f.name, $b.getattr(self, $bound(f, "name"))]; } })()]));
return $map([...(function* () { for (const [k, v] of $iter($m.items(found))) { if (!($truth($b.isinstance(v, WidthProfile)))) continue; yield [k, v]; } })()]);
}
problems(key, width) {
const self = this; let found;

(found = [...(function* () { for (const [name, profile] of $iter($m.items(self.profiles()))) { for (const problem of $iter(profile.problems(("" + $str(key) + "." + $str(name)), width))) { yield problem; }} })()]);
if (($truth($b.isinstance(self.before, Transition)) && (self.before.centre_roll >= width))) {
$m.append(found, new Problem(("" + "must be less than the belt width " + $str(display__display(width, "length"))), "Give the width of belt on the centre roll.", undefined, ("" + $str(key) + ".before.centre_roll"), display__display($bound(self.before, "centre_roll"), "length")));
}
return found;
}
}
$sig(Across, ["shell_profile", "worn_depth", "build_up", "misalignment", "deflection", "entry_profile", "before", "after", "strips"], false, {shell_profile: () => null, worn_depth: () => null, build_up: () => null, misalignment: () => 0.0, deflection: () => 0.0, entry_profile: () => null, before: () => null, after: () => null, strips: () => 32});
class Variant extends Kind {
$init(tag, meaning, ...tables) {
const self = this; (self.tag = tag);
(self.tables = $map([...(function* () { for (const t of $iter(tables)) { yield [t.title, $call(tables$Table, [$bound(t, "title"), tables__need(tag, meaning, new Choice([t.title])), ...$iter(t.entries)], [["of", t.of]])]; } })()]));
}
built(value, report, more = new Map()) {
const self = this; 
if ((!$truth($b.isinstance(value, Record)) || !$truth(value.sound()))) {
return null;
}
return $method($at(self.tables, $at(value, self.tag)), "built", [value, report], [...more]);
}
read(raw, place, report) {
const self = this; let allowed, options, word;

if (!$truth($b.isinstance(raw, "dict"))) {
report.add(place, "must be a table", "Write its keys below its name in [ ].", raw);
return $ca9ba;
}
(options = $b.tuple($bound(self, "tables")));
if ((!$in(self.tag, raw))) {
(allowed = $m.join(", ", (function* () { for (const option of $iter(options)) { yield $shown(option); } })()));
report.add([...$iter(place), self.tag], "missing", ("" + "Write one of " + $str(allowed) + "."));
return $ca9ba;
}
(word = new Choice(options).read($at(raw, self.tag), [...$iter(place), self.tag], report));
return ((word === $ca9ba) ? $ca9ba : $at(self.tables, word).read(raw, place, report));
}
}
class Pulley extends $Object {
__post_init__() {
const self = this; let problems, worn;
(problems = $add(limits__name_problems("name", $bound(self, "name")), limits__limit_problems(self, $bound(self, "LIMITS"))));
(problems = $add(problems, criteria__choice_problems(self, $map([["side", $ca867]]))));
(problems = $add(problems, uncertain__uncertainty_problems($bound(self, "uncertainty"), $c2e28)));
(worn = ($truth(self.across) ? self.across.worn_depth : null));
if (((worn != null) && (worn.largest >= self.lagging.thickness))) {
$m.append(problems, new Problem($add("must be less than the lagging thickness ", display__display($bound(self.lagging, "thickness"), "length")), "Give the depth worn off, on radius.", undefined, "across.worn_depth", display__display($bound(worn, "largest"), "length")));
}
limits__raise_all(problems);
}
lagging_in(condition) {
const self = this; 
if (!$truth(condition)) {
return self.lagging;
}
try {
return $b.next((function* () { for (const lagging of $iter(self.conditions)) { if (!(($eq(lagging.condition, condition)))) continue; yield lagging; } })());
} catch ($error) {
if ($error instanceof $StopIteration) {
throw new $KeyError(condition);
} else throw $error;
}
}
in_condition(condition) {
const self = this; 
return ($truth(condition) ? $replaced(self, new Map([["lagging", self.lagging_in(condition)]])) : self);
}
get radius() {
const self = this; 
return (self.diameter / 2.0);
}
}
$sig(Pulley, ["name", "diameter", "wrap_angle", "lagging", "overrun", "recovery", "creep_limit", "side", "mass", "across", "uncertainty", "sources", "conditions"], false, {overrun: () => null, recovery: () => true, creep_limit: () => null, side: () => "pulley", mass: () => null, across: () => null, uncertainty: () => new Map(), sources: () => new Map(), conditions: () => []});
class Sag extends $Object {
__post_init__() {
const self = this; limits__raise_all(limits__limit_problems(self, $bound(self, "LIMITS")));
}
get tension() {
const self = this; 
return ($mul($mul(self.line_mass, 9.80665), self.spacing) / $mul(8.0, self.share));
}
}
$sig(Sag, ["spacing", "line_mass", "share"], false, {share: () => 0.02});
class Flight extends $Object {
__post_init__() {
const self = this; limits__raise_all($add(limits__name_problems("name", $bound(self, "name")), limits__limit_problems(self, $bound(self, "LIMITS"))));
}
get rise() {
const self = this; 
if ((self.lift != null)) {
return self.lift;
}
return ((self.slope == null) ? 0.0 : $mul(self.length, $math.sin($bound(self, "slope"))));
}
misfits() {
const self = this; let given, long, message, remedy, room, steep;

if (($b.abs($bound(self, "rise")) >= self.length)) {
([given, long] = [display__display($bound(self, "rise"), "length"), display__display($bound(self, "length"), "length")]);
(message = ("" + "must be less than the length " + $str(long)));
return [new Problem(message, undefined, undefined, "lift", given)];
}
if (((self.lift == null) || (self.slope == null))) {
return [];
}
(steep = $mul(self.length, $math.sin($bound(self, "slope"))));
(room = $b.max($mul(0.01, $b.abs(steep)), $mul(0.00175, self.length)));
if (($b.abs($sub(self.lift, steep)) <= room)) {
return [];
}
(message = ("" + "contradicts lift " + $str(display__display($bound(self, "lift"), "length")) + ", it makes "));
(message = $add(message, display__display(steep, "length")));
(remedy = "Correct one of them, or leave it out.");
(given = display__display($bound(self, "slope"), "angle"));
return [new Problem(message, remedy, undefined, "slope", given)];
}
get sine() {
const self = this; 
return (self.rise / self.length);
}
get cosine() {
const self = this; 
return $math.sqrt($sub(1.0, $pow(self.sine, 2)));
}
}
$sig(Flight, ["name", "length", "lift", "slope", "curve_radius", "friction_factor", "carry_idler_mass", "return_idler_mass", "carry_spacing", "return_spacing"], false, {lift: () => null, slope: () => null, curve_radius: () => null, friction_factor: () => null, carry_idler_mass: () => null, return_idler_mass: () => null, carry_spacing: () => null, return_spacing: () => null});
class LoadingPoint extends $Object {
__post_init__() {
const self = this; let given, message, problem, problems, remedy;
(problems = $add(limits__name_problems("name", $bound(self, "name")), limits__limit_problems(self, $bound(self, "LIMITS"))));
if (($truth(self.flight) && (self.position != null))) {
([message, remedy] = ["contradicts flight", "Leave one of them out."]);
(given = display__display($bound(self, "position"), "length"));
$m.append(problems, new Problem(message, remedy, undefined, "position", given));
}
if (((self.capacity != null) && (self.material_mass != null))) {
(message = "means the same as capacity");
(remedy = "Leave one of them out.");
$m.append(problems, new Problem(message, remedy, undefined, "material_mass"));
}
if (((self.capacity == null) && (self.material_mass == null))) {
(remedy = "Write capacity = \"1000 t/h\", or material_mass.");
(problem = new Problem("missing", remedy, undefined, "capacity", undefined, undefined, "missing"));
$m.append(problems, problem);
}
if (((self.skirt_width != null) && (self.density == null))) {
(remedy = "Write density = \"1600 kg/m3\".");
(problem = new Problem("missing", remedy, undefined, "density", undefined, undefined, "missing"));
$m.append(problems, problem);
}
limits__raise_all(problems);
}
}
$sig(LoadingPoint, ["name", "flight", "position", "capacity", "material_mass", "material_speed", "skirt_width", "acceleration_length", "belt_friction", "skirt_friction", "density"], false, {flight: () => "", position: () => null, capacity: () => null, material_mass: () => null, material_speed: () => 0.0, skirt_width: () => null, acceleration_length: () => null, belt_friction: () => 0.5, skirt_friction: () => 0.7, density: () => null});
class ConveyorCase extends $Object {
__post_init__() {
const self = this; limits__raise_all(limits__name_problems("name", $bound(self, "name")));
}
factor_of(flight) {
const self = this; 
return ($truth(self.loads(flight)) ? $m.get(self.factor, $bound(flight, "name"), 1.0) : 0.0);
}
loads(flight) {
const self = this; 
if (($eq(self.loaded, "inclines"))) {
return (flight.rise > 0.0);
}
if (($eq(self.loaded, "declines"))) {
return (flight.rise < 0.0);
}
if (($in(self.loaded, ["all", "none"]))) {
return ($eq(self.loaded, "all"));
}
return ($in(flight.name, self.loaded));
}
}
$sig(ConveyorCase, ["name", "loaded", "factor", "kind"], false, {loaded: () => "all", factor: () => new Map(), kind: () => "running"});
class Travel extends $Object {
__post_init__() {
const self = this; limits__raise_all(limits__limit_problems(self, $bound(self, "LIMITS")));
}
}
$sig(Travel, ["temperature_range", "thermal_expansion", "permanent_elongation", "splice_length"], false, {temperature_range: () => null, thermal_expansion: () => null, permanent_elongation: () => null, splice_length: () => null});
class Cema extends $Object {
__post_init__() {
const self = this; limits__raise_all(limits__limit_problems(self, $bound(self, "LIMITS")));
}
}
$sig(Cema, ["idler_friction", "temperature_factor", "ky", "other"], false, {temperature_factor: () => 1.0, other: () => 0.0});
class ConveyorData extends $Object {
get material() {
const self = this; 
if ($truth(self.loadings)) {
return $b.sum((function* () { for (const i of $iter($b.range($b.len($bound(self, "loadings"))))) { yield self.loading_mass(i); } })());
}
if ((self.material_mass != null)) {
return self.material_mass;
}
return (description___known($bound(self, "capacity"), 0.0) / description___known($bound(self, "speed"), 1.0));
}
sizes() {
const self = this; 
return [self.length, self.lift, self.belt_mass, self.carry_idler_mass, self.return_idler_mass, description___known($bound(self, "material_mass"), NaN), description___known($bound(self, "capacity"), NaN), self.friction_factor, description___known($bound(self, "secondary_resistance"), NaN), (($eq(self.special_resistance, 0.0)) ? NaN : self.special_resistance), description___known($bound(self, "start_time"), NaN), description___known($bound(self, "stop_time"), NaN), description___known($bound(self, "take_up_tension"), NaN), description___known($bound(self, "counterweight"), NaN)];
}
get take_up() {
const self = this; 
if ((self.take_up_tension != null)) {
return self.take_up_tension;
}
return ($mul(description___known($bound(self, "counterweight"), 0.0), 9.80665) / self.sheave_ratio);
}
get coefficient() {
const self = this; 
if (((self.secondary_resistance != null) || $truth(self.itemised))) {
return null;
}
return description___known($bound(self, "length_coefficient"), resistance__coefficient_at($bound(self, "length")));
}
get itemised() {
const self = this; 
return ($b.len($bound(self, "locals")) > 0);
}
get take_up_behind() {
const self = this; let at_tail, first, passed, way, ways, whole;

if ((($b.len($bound(self, "drives")) < 2) || ($eq(self.take_up_after, $at(self.drives, $neg(1)).pulley)))) {
return null;
}
if ($truth(self.take_up_after)) {
return self.take_up_after;
}
(whole = $mul(2.0, self.length));
(first = self.along($at(self.drives, 0)));
(ways = [...(function* () { for (const drive of $iter(self.drives)) { yield ($sub(self.along(drive), first) % whole); } })()]);
(at_tail = (self.take_up_distance >= $mul(self.length, $sub(1.0, 1e-09))));
(way = ($sub($sub($add(self.length, self.take_up_distance), first), ($truth(at_tail) ? 1e-06 : 0.0)) % whole));
(passed = [...(function* () { for (const [drive, at] of $iter($b.zip($bound(self, "drives"), ways, $k({strict: true})))) { if (!((at <= way))) continue; yield drive.pulley; } })()]);
return (($eq($b.len(passed), $b.len($bound(self, "drives")))) ? null : $at(passed, $neg(1)));
}
along(drive) {
const self = this; let position;

if (($eq(drive.at, "head"))) {
return self.length;
}
if (($eq(drive.at, "tail"))) {
return $mul(2.0, self.length);
}
(position = description___known($bound(drive, "position"), 0.0));
return (($eq(drive.at, "carry")) ? position : $add(self.length, position));
}
loading_mass(index) {
const self = this; let point;

if (!$truth(self.loadings)) {
return self.material;
}
(point = $at(self.loadings, index));
if ((point.material_mass != null)) {
return point.material_mass;
}
return (description___known($bound(point, "capacity"), 0.0) / description___known($bound(self, "speed"), 1.0));
}
get course_flights() {
const self = this; 
return $or(self.flights, () => [new Flight("conveyor", self.length, self.lift)]);
}
get course_drives() {
const self = this; 
return $or(self.drives, () => [new DrivePlace("", self.drive_at)]);
}
loading_positions() {
const self = this; let flight, now, starts;

([starts, now] = [$map([["", 0.0]]), 0.0]);
for (flight of $iter(self.flights)) {
$put(starts, flight.name, now);
(now = $add(now, flight.length));
}
if (!$truth(self.loadings)) {
return [0.0];
}
return [...(function* () { for (const point of $iter(self.loadings)) { yield ((point.position == null) ? $m.get(starts, $bound(point, "flight"), 0.0) : point.position); } })()];
}
get unusual_friction() {
const self = this; let least, most;

([least, most] = $c32fc);
if ((least <= self.friction_factor && self.friction_factor <= most)) {
return "";
}
return ("" + ", outside the usual " + $format(least, ("" + ".3f")) + " to " + $format(most, ("" + ".3f")));
}
}
$sig(ConveyorData, ["length", "lift", "belt_mass", "carry_idler_mass", "return_idler_mass", "material_mass", "capacity", "friction_factor", "length_coefficient", "secondary_resistance", "special_resistance", "return_share", "start_factor", "start_time", "stop_time", "take_up_tension", "counterweight", "take_up_distance", "drive_at", "speed", "sheave_ratio", "flights", "loadings", "cases", "drives", "locals", "take_up_after", "carry_spacing", "return_spacing", "sag_limit", "rest_friction", "width", "thickness", "steel", "travel", "cema", "uncertainty"], false, {lift: () => 0.0, material_mass: () => null, capacity: () => null, friction_factor: () => 0.02, length_coefficient: () => null, secondary_resistance: () => null, special_resistance: () => 0.0, return_share: () => 0.0, start_factor: () => null, start_time: () => null, stop_time: () => null, take_up_tension: () => null, counterweight: () => null, take_up_distance: () => 0.0, drive_at: () => "head", speed: () => null, sheave_ratio: () => 2.0, flights: () => [], loadings: () => [], cases: () => [], drives: () => [], locals: () => [], take_up_after: () => "", carry_spacing: () => null, return_spacing: () => null, sag_limit: () => 0.01, rest_friction: () => 0.5, width: () => null, thickness: () => null, steel: () => false, travel: () => null, cema: () => null, uncertainty: () => new Map()});
class Conveyor extends ConveyorData {
__post_init__() {
const self = this; let given, message, problems;
(problems = limits__limit_problems(self, $bound(self, "LIMITS")));
(given = new Set((function* () { for (const key of $iter(self.LIMITS)) { if (!(($b.getattr(self, key) != null))) continue; yield key; } })()));
(problems = $add(problems, choices__choices($merged(given, ($truth(self.loadings) ? new Set(["loading"]) : $b.set())))));
if ((!$in(self.drive_at, $c6846))) {
(message = ("" + "must be one of " + $str($m.join(", ", $c6846))));
$m.append(problems, new Problem(message, undefined, undefined, "drive_at", $shown($bound(self, "drive_at"))));
}
(problems = $add(problems, uncertain__uncertainty_problems($bound(self, "uncertainty"), $cac72)));
(problems = $add(problems, [...(function* () { for (const key of $iter($cac72)) { if (!((($in(key, self.uncertainty)) && ($b.getattr(self, key) == null)))) continue; yield new Problem(("" + $str(key) + " is missing"), "Give both.", undefined, ("" + "uncertainty." + $str(key))); } })()]));
limits__raise_all($or(problems, () => $b.list(self.misfits())));
}
*misfits() {
const self = this; let given, long, message, stated;

(long = display__display($bound(self, "length"), "length"));
if (($b.abs($bound(self, "lift")) >= self.length)) {
(given = display__display($bound(self, "lift"), "length"));
yield new Problem(("" + "must be less than the length " + $str(long)), undefined, undefined, "lift", given);
}
if ((self.take_up_distance > self.length)) {
(given = display__display($bound(self, "take_up_distance"), "length"));
(message = ("" + "must be at most the length " + $str(long)));
yield new Problem(message, undefined, undefined, "take_up_distance", given);
}
(stated = $or((self.secondary_resistance != null), () => (self.length_coefficient != null)));
if ((!$truth(stated) && !$truth(self.itemised))) {
yield* $iter(resistance__no_coefficient($bound(self, "length")));
}
yield* $iter(fits__flight_misfits(self));
}
states() {
const self = this; let states;

(states = self.reckoned());
limits__raise_all(self.unfit(states));
return $b.tuple(states);
}
reckoned() {
const self = this; 
return course__course_states(self);
}
unfit(states) {
const self = this; let message, problems, remedy, slack, state;

(problems = []);
if (((self.start_factor != null) && ($at(states, 0).pull <= 0.0))) {
(message = "no factor starts a conveyor that runs by itself");
(remedy = "Write start_time = \"20 s\" instead.");
$m.append(problems, new Problem(message, remedy, undefined, "start_factor"));
}
for (state of $iter(states)) {
(slack = state.slack_problem());
(problems = $add(problems, ((slack == null) ? [] : [slack])));
}
return problems;
}
}
$sig(Conveyor, ["length", "lift", "belt_mass", "carry_idler_mass", "return_idler_mass", "material_mass", "capacity", "friction_factor", "length_coefficient", "secondary_resistance", "special_resistance", "return_share", "start_factor", "start_time", "stop_time", "take_up_tension", "counterweight", "take_up_distance", "drive_at", "speed", "sheave_ratio", "flights", "loadings", "cases", "drives", "locals", "take_up_after", "carry_spacing", "return_spacing", "sag_limit", "rest_friction", "width", "thickness", "steel", "travel", "cema", "uncertainty"], false, {lift: () => 0.0, material_mass: () => null, capacity: () => null, friction_factor: () => 0.02, length_coefficient: () => null, secondary_resistance: () => null, special_resistance: () => 0.0, return_share: () => 0.0, start_factor: () => null, start_time: () => null, stop_time: () => null, take_up_tension: () => null, counterweight: () => null, take_up_distance: () => 0.0, drive_at: () => "head", speed: () => null, sheave_ratio: () => 2.0, flights: () => [], loadings: () => [], cases: () => [], drives: () => [], locals: () => [], take_up_after: () => "", carry_spacing: () => null, return_spacing: () => null, sag_limit: () => 0.01, rest_friction: () => 0.5, width: () => null, thickness: () => null, steel: () => false, travel: () => null, cema: () => null, uncertainty: () => new Map()});
class Rule extends $Object {
*checks(of) {
const self = this; let check, found, limit, noun, shown, text, title, value, why;

if ((self.find_checks != null)) {
yield* $iter(self.find_checks(of));
return null;
}
(text = ($truth(self.text) ? self.text(of) : null));
(found = ($in(self.result, of.state.found)));
if (((text == null) || ($truth(self.result) && !$truth(found) && !$truth(of.unknown)))) {
return null;
}
(value = (($truth(self.result) && !$truth(found)) ? NaN : self.compared($bound(of, "state"))));
(why = $or(text.why, () => ($truth(self.result) ? of.unknown : "")));
if ((!($truth(text.missing) || $truth(why)) && $truth($math.isnan(value)))) {
(why = "value unknown");
}
if (($truth(text.missing) || $truth(why))) {
([title, noun] = [text.title, text.noun]);
(check = rule__not_checked($bound(self, "name"), title, noun, $bound(of, "place"), text.missing, why));
(shown = $replaced(check, new Map([["value", value], ["dimension", self.dimension]])));
yield ($truth(text.show_value) ? shown : check);
return null;
}
(limit = self.limit_at(of));
if ((self.rounded != null)) {
(value = self.rounded(value, limit, $bound(of, "state")));
}
yield self.for_drive($bound(of, "drive")).compare(value, limit, $bound(of, "place"), text);
}
compared(state) {
const self = this; 
return ($truth(self.value) ? self.value(state) : $at(state.found, self.result));
}
rise_to(state, limit) {
const self = this; let more, now, per_tension;

(more = $mul(state.width, 1000.0));
(now = self.compared(state));
(per_tension = ($sub(self.compared(state.raised(more)), now) / more));
return ($sub(limit, now) / per_tension);
}
limit_at(of) {
const self = this; let allowed;

(allowed = ($truth(self.allowed) ? self.allowed(of) : null));
return self.limited(((allowed == null) ? NaN : allowed), $bound(of, "state"));
}
for_drive(drive) {
const self = this; let firm;

if ((self.firm == null)) {
return self;
}
(firm = self.firm(drive));
return $replaced(self, new Map([["missed", ($truth(firm) ? "FAILS" : self.missed)], ["binding", firm]]));
}
compare(value, limit, place, text) {
const self = this; let fails, headline, level, passes;

(passes = $and(!$truth($math.isnan(value)), () => check__keeps(value, limit, self.at_most)));
(fails = numbers__beyond(value, $bound(self, "fails_beyond"), $bound(self, "at_most")));
(headline = (($truth(fails) && $truth(text.fails)) ? text.fails : text.headline));
(level = ($truth(fails) ? "FAILS" : self.missed));
return new Check(self.name, text.title, ($truth(passes) ? "OK" : level), place, undefined, $or(self.result, () => self.name), text.noun, value, limit, self.dimension, self.is_percent, self.at_most, ($truth(passes) ? "" : headline), ($truth(passes) ? "" : text.action), ($truth(passes) ? "" : text.full), ($truth(passes) ? "" : text.label), text.source, undefined, undefined, text.more, self.binding);
}
limited(allowed, state) {
const self = this; 
return ((self.limit == null) ? allowed : self.limit(allowed, state));
}
}
$sig(Rule, ["name", "what", "missed", "fails_beyond", "is_percent", "at_most", "dimension", "tension", "binding", "firm", "result", "value", "allowed", "limit", "rounded", "pulls", "of_rows", "of_runs", "text", "find_checks"], false, {missed: () => "ATTENTION", fails_beyond: () => NaN, is_percent: () => false, at_most: () => true, dimension: () => "number", tension: () => "", binding: () => true, firm: () => null, result: () => "", value: () => null, allowed: () => null, limit: () => null, rounded: () => null, pulls: () => false, of_rows: () => true, of_runs: () => true, text: () => null, find_checks: () => null});
class DesignFriction extends $Object {
}
$sig(DesignFriction, ["standard", "surface", "condition", "friction", "provenance"], false, {});
class KeyFigure extends $Tuple {
}
$sig(KeyFigure, ["name", "better", "elsewhere"], false, {better: () => "low", elsewhere: () => []});
class LaggingCost extends $Object {
}
$sig(LaggingCost, ["name", "surface", "material", "installation", "currency", "area", "life_years", "ten_year_cost", "provenance"], false, {});
class ModulusRatio extends $Tuple {
}
$sig(ModulusRatio, ["least", "most", "source"], false, {});
class Cost extends $Object {
__post_init__() {
const self = this; let message, problems, years;
(problems = limits__limit_problems(self, $bound(self, "LIMITS")));
(years = self.life_years);
if (!(0.0 < $at(years, 0) && $at(years, 0) <= $at(years, 1) && $at(years, 1) < Infinity)) {
(message = "must be the shortest and the longest life in years, both more than 0");
$m.append(problems, new Problem(message, undefined, undefined, "life_years", $shown($b.list(years))));
}
limits__raise_all(problems);
}
}
$sig(Cost, ["material", "installation", "currency", "area", "life_years"], false, {});
class Block extends $Object {
__post_init__() {
const self = this; let message, problems;
(problems = limits__limit_problems(self, $bound(self, "LIMITS")));
if ((!$in(self.shape, $c7017))) {
(message = ("" + "must be one of " + $str($m.join(", ", $c7017))));
$m.append(problems, new Problem(message, undefined, undefined, "shape", $shown($bound(self, "shape"))));
}
limits__raise_all(problems);
}
get shape_factor() {
const self = this; let factor;

(factor = compression__shape_factor(($eq(self.shape, "square")), $bound(self, "width"), $bound(self, "height")));
return factor;
}
}
$sig(Block, ["shape", "width", "height", "stiffening", "contact_fraction"], false, {shape: () => "square", stiffening: () => 0.54, contact_fraction: () => 1.0});
class ConditionFactor extends $Object {
__post_init__() {
const self = this; limits__raise_all(limits__limit_problems(self, $bound(self, "LIMITS")));
}
}
$sig(ConditionFactor, ["factor", "source"], false, {});
class FrictionFactor extends $Object {
__post_init__() {
const self = this; let bad, count, message, n, problems;
([n, problems] = [$b.len($bound(self, "at")), $b.list()]);
if (((n < 2) || (!$eq($b.len($bound(self, "factor")), n)))) {
(count = ("" + $str(n) + " values and " + $str($b.len($bound(self, "factor"))) + " factors"));
(message = "must be as many factors as values, two at least");
$m.append(problems, new Problem(message, undefined, undefined, "factor", count));
}
if ($truth($b.any((function* () { for (const [before, after] of $iter($b.pairwise($bound(self, "at")))) { yield (after <= before); } })()))) {
$m.append(problems, new Problem("must ascend", undefined, undefined, "at", $shown($b.list($bound(self, "at")))));
}
(bad = [...(function* () { for (const v of $iter(self.factor)) { if (!(!(0.0 < v && v <= 10.0))) continue; yield v; } })()]);
if ($truth(bad)) {
(message = "must be more than 0 and at most 10");
$m.append(problems, new Problem(message, undefined, undefined, "factor", $shown($at(bad, 0))));
}
limits__raise_all(problems);
}
least(low, high) {
const self = this; let inside;

(inside = [...(function* () { for (const [x, f] of $iter($b.zip($bound(self, "at"), $bound(self, "factor"), $k({strict: true})))) { if (!((low <= x && x <= high))) continue; yield f; } })()]);
return $b.min([...$iter(inside), self._of(low), self._of(high)]);
}
_of(value) {
const self = this; let f, f1, rows, x, x1;

(rows = $b.list($b.zip($bound(self, "at"), $bound(self, "factor"), $k({strict: true}))));
for ([[x, f], [x1, f1]] of $iter($b.pairwise(rows))) {
if ((x <= value && value < x1)) {
return $add($mul(($sub(f1, f) / $sub(x1, x)), $sub(value, x)), f);
}
}
return ((value < $at(self.at, 0)) ? $at(self.factor, 0) : $at(self.factor, $neg(1)));
}
}
$sig(FrictionFactor, ["at", "factor", "source"], false, {});
class Fit extends $Object {
get knots() { return $kept(this, "knots", this.$find_knots()); }
get log_covariance() { return $kept(this, "log_covariance", this.$find_log_covariance()); }
__post_init__() {
const self = this; let message, n, problems;
(n = $b.len($bound(self, "parameters")));
(problems = limits__limit_problems(self, $c9bd3));
if ((($b.len($b.set($bound(self, "parameters"))) < n) || !$truth(n))) {
(message = "must name each fitted parameter once");
$m.append(problems, new Problem(message, undefined, undefined, "parameters", $b.str(n)));
}
if (((!$eq($b.len($bound(self, "values")), n)) || !$truth($b.all($b.map($math.isfinite, $bound(self, "values")))))) {
(message = ("" + "must be " + $str(n) + " finite numbers, one for each parameter"));
$m.append(problems, new Problem(message, undefined, undefined, "values", $b.str($b.len($bound(self, "values")))));
}
(problems = $add(problems, self._covariance_problems(n)));
limits__raise_all(problems);
}
_covariance_problems(n) {
const self = this; let apart, given, matrix, message, numbers, rows;
(rows = [...(function* () { for (const row of $iter(self.covariance)) { yield $b.len(row); } })()]);
if ((!$eq(rows, $mul([n], n)))) {
(given = ("" + $str($b.len(rows)) + " rows of " + $str($b.sorted($b.set(rows))) + " numbers"));
(message = ("" + "must be " + $str(n) + " rows of " + $str(n) + " numbers, one for each parameter"));
return [new Problem(message, undefined, undefined, "covariance", given)];
}
([matrix, message] = [self.covariance, ""]);
(numbers = [...(function* () { for (const row of $iter(matrix)) { for (const v of $iter(row)) { yield v; }} })()]);
(apart = [...(function* () { for (const i of $iter($b.range(n))) { for (const j of $iter($b.range(i))) { yield $b.abs($sub($at($at(matrix, i), j), $at($at(matrix, j), i))); }} })()]);
if (!$truth($b.all($b.map($math.isfinite, numbers)))) {
(message = "must be finite");
} else {
if (($b.max(apart, $k({default: 0.0})) > $mul(1e-09, $b.max($b.map($b.abs, numbers), $k({default: 0.0}))))) {
(message = "must be symmetric");
} else {
if (!$truth(fit___has_no_negative(matrix, $mul(1e-08, n)))) {
(message = "must have no negative eigenvalue: no variance is negative");
}
}
}
return ($truth(message) ? [new Problem(message, undefined, undefined, "covariance")] : []);
}
$find_knots() {
const self = this; let found, named;

(found = [...(function* () { for (const name of $iter(self.parameters)) { yield $m.fullmatch($c29b0, name); } })()]);
if (($b.min($bound(self, "values")) <= 0.0)) {
return [];
}
(named = $b.tuple((function* () { for (const match of $iter(found)) { if (!($truth(match))) continue; yield [$sub($b.int($at(match, 1)), 1), $at(match, 2)]; } })()));
return (($eq($b.len(named), $b.len(found))) ? named : []);
}

}
$sig(Fit, ["parameters", "values", "covariance", "residual_noise", "date", "method", "misfit", "misfit_accepted", "coverage_factor"], false, {residual_noise: () => null, date: () => "", method: () => "", misfit: () => [], misfit_accepted: () => "", coverage_factor: () => 1.96});
class FileKind extends $Tuple {
}
$sig(FileKind, ["words", "command", "keys"], false, {});
class Induction extends Motor {
_problems() {
const self = this; let message;
if (($mul(0.8, self.synchronous_speed) <= self.rated_speed && self.rated_speed < self.synchronous_speed)) {
return [];
}
(message = ("" + "must be below the synchronous speed " + $str(motors___rpm($bound(self, "synchronous_speed"))) + " by at most 20 %"));
return [new Problem(message, undefined, undefined, "rated_speed", motors___rpm($bound(self, "rated_speed")))];
}
shaft_speed(load) {
const self = this; let breakdown_slip, part, ratio, x;

(ratio = self.breakdown_ratio);
(x = (load / ratio));
(part = (x / $add(1.0, $math.sqrt($b.max($sub(1.0, $mul(x, x)), 0.0)))));
(breakdown_slip = $mul(self.rated_slip, $add(ratio, $math.sqrt($sub($mul(ratio, ratio), 1.0)))));
return $mul(self.synchronous_speed, $b.max($sub(1.0, $mul(breakdown_slip, part)), 0.001));
}
largest_load() {
const self = this; 
return self.breakdown_ratio;
}
bears(momentary) {
const self = this; 
return $b.min(super.bears(momentary), $mul(0.81, self.breakdown_ratio));
}
get rated_slip() {
const self = this; 
return $sub(1.0, (self.rated_speed / self.synchronous_speed));
}
}
$sig(Induction, ["rated_power", "rated_speed", "gear_ratio", "gear_efficiency", "motor_efficiency", "count", "brakes", "synchronous_speed", "breakdown_ratio"], false, {gear_ratio: () => 1.0, gear_efficiency: () => 1.0, motor_efficiency: () => null, count: () => 1, brakes: () => true, breakdown_ratio: () => 2.5});
class FluidCoupling extends Induction {
get _end() { return $kept(this, "_end", this.$find__end()); }
_problems() {
const self = this; let count, key, loads, message, problems, rising, slips, top, values;
(problems = super._problems());
([loads, slips] = [self.coupling_load, self.coupling_slip]);
if (((!$eq($b.len(loads), $b.len(slips))) || ($b.len(loads) < 2))) {
(count = ("" + $str($b.len(loads)) + " and " + $str($b.len(slips))));
(message = "the curve needs as many torques as slips, two or more of each");
$m.append(problems, new Problem(message, undefined, undefined, "coupling_slip", count));
}
for ([key, values, top] of $iter([["coupling_load", loads, 10.0], ["coupling_slip", slips, 0.9]])) {
(rising = $b.all((function* () { for (const [a, b] of $iter($b.pairwise(values))) { yield (a < b); } })()));
if (!($truth(values) && ($eq($at(values, 0), 0.0)) && $truth(rising) && ($at(values, $neg(1)) <= top))) {
(message = ("" + "must rise from 0 to at most " + $format(top, ("" + "g"))));
$m.append(problems, new Problem(message, undefined, undefined, key, $b.str($b.list(values))));
}
}
return problems;
}
shaft_speed(load) {
const self = this; let pump;

(pump = super.shaft_speed(load));
return $mul(pump, $sub(1.0, self._slip($mul(load, $pow((self.rated_speed / pump), 2)))));
}
_slip(load) {
const self = this; let i, loads, size, slip, slips, weight;
([size, loads, slips] = [$b.abs(load), self.coupling_load, self.coupling_slip]);
(i = 0);
while (((i < $sub($b.len(loads), 2)) && (size > $at(loads, $add(i, 1))))) {
(i = $add(i, 1));
}
(weight = ($sub(size, $at(loads, i)) / $sub($at(loads, $add(i, 1)), $at(loads, i))));
(slip = $add($at(slips, i), $mul(weight, $sub($at(slips, $add(i, 1)), $at(slips, i)))));
return $math.copysign($b.min(slip, 0.95), load);
}
largest_load() {
const self = this; 
return self._end;
}
$find__end() {
const self = this; let _, high, load, low, pump;

([low, high] = [0.0, self.breakdown_ratio]);
for (_ of $iter($b.range(60))) {
(load = $mul(0.5, $add(low, high)));
(pump = super.shaft_speed(load));
if (($mul(load, $pow((self.rated_speed / pump), 2)) <= $at(self.coupling_load, $neg(1)))) {
(low = load);
} else {
(high = load);
}
}
return (($eq(high, self.breakdown_ratio)) ? high : low);
}
}
$sig(FluidCoupling, ["rated_power", "rated_speed", "gear_ratio", "gear_efficiency", "motor_efficiency", "count", "brakes", "synchronous_speed", "breakdown_ratio", "coupling_load", "coupling_slip"], false, {gear_ratio: () => 1.0, gear_efficiency: () => 1.0, motor_efficiency: () => null, count: () => 1, brakes: () => true, breakdown_ratio: () => 2.5});
class ElongationAt extends $Tuple {
__str__() {
const self = this; 
return ("" + $format($mul(100.0, self.strain), ("" + ".4g")) + " % at " + $format($mul(100.0, self.share), ("" + ".4g")) + " %");
}
}
$sig(ElongationAt, ["strain", "share"], false, {});
class Transition extends $Object {
__post_init__() {
const self = this; let message, problems;
(problems = limits__limit_problems(self, $bound(self, "LIMITS")));
if ((!$in(self.depth, $c8b63))) {
(message = ("" + "must be one of " + $str($m.join(", ", $c8b63))));
$m.append(problems, new Problem(message, undefined, undefined, "depth", $shown($bound(self, "depth"))));
}
limits__raise_all(problems);
}
}
$sig(Transition, ["length", "trough_angle", "centre_roll", "depth"], false, {depth: () => "full"});
class TiltResistance extends $Object {
__post_init__() {
const self = this; let message, problems;
(problems = limits__limit_problems(self, $bound(self, "LIMITS")));
if ((!$in(self.strand, ["carry", "return"]))) {
(message = "must be one of carry, return");
$m.append(problems, new Problem(message, undefined, undefined, "strand", $shown($bound(self, "strand"))));
}
limits__raise_all(problems);
}
per_weight(whole) {
const self = this; let part;

(part = ((self.length == null) ? 1.0 : $b.min(1.0, (self.length / whole))));
return $mul($mul($mul(self.trough_coefficient, self.friction), $math.sin($bound(self, "angle"))), part);
}
}
$sig(TiltResistance, ["strand", "angle", "trough_coefficient", "friction", "length"], false, {strand: () => "carry", trough_coefficient: () => 0.4, friction: () => 0.3, length: () => null});
class PulleyResistance extends $Object {
__post_init__() {
const self = this; limits__raise_all($add(limits__limit_problems(self, $bound(self, "LIMITS")), flight__place_problems($bound(self, "at"), $bound(self, "position"))));
}
wrap(tension, width, thickness, steel) {
const self = this; let constant, first, one;

([first, constant] = ($truth(steel) ? [12.0, 200.0] : [9.0, 140.0]));
(one = ($mul($mul($mul(first, width), $add(constant, ($mul(0.01, tension) / width))), thickness) / self.diameter));
return $mul(self.count, one);
}
bearing(tension) {
const self = this; let load;

(load = $math.hypot($mul($mul(2.0, tension), $math.sin($mul(0.5, self.wrap_angle))), $mul(self.mass, 9.80665)));
return ($mul($mul($mul(self.count, 0.005), load), self.shaft_diameter) / self.diameter);
}
}
$sig(PulleyResistance, ["at", "position", "diameter", "shaft_diameter", "wrap_angle", "mass", "count"], false, {at: () => "head", position: () => null, shaft_diameter: () => 0.0, wrap_angle: () => 3.141592653589793, mass: () => 0.0, count: () => 1});
class loop$Spot extends $Tuple {
}
$sig(loop$Spot, ["strand", "position", "rank", "order", "kind", "which", "name"], false, {});
class PointResistance extends $Object {
__post_init__() {
const self = this; limits__raise_all($add(limits__limit_problems(self, $bound(self, "LIMITS")), flight__place_problems($bound(self, "at"), $bound(self, "position"))));
}
}
$sig(PointResistance, ["at", "position", "force"], false, {at: () => "head", position: () => null});
class SkirtResistance extends $Object {
__post_init__() {
const self = this; limits__raise_all(limits__limit_problems(self, $bound(self, "LIMITS")));
}
force(material) {
const self = this; let squared;

(squared = ($mul(material, material) / $mul(self.density, $pow(self.width, 2))));
return $mul($mul($mul(self.friction, squared), 9.80665), self.length);
}
}
$sig(SkirtResistance, ["position", "length", "width", "density", "friction"], false, {position: () => 0.0, friction: () => 0.7});
class Segment extends $Object {
get moving() {
const self = this; 
return $mul(self.length, $add(self.carried, self.rotating));
}
}
$sig(Segment, ["strand", "flight", "position", "length", "lift", "carried", "rotating", "forces"], false, {});
class CleanerResistance extends $Object {
__post_init__() {
const self = this; limits__raise_all($add(limits__limit_problems(self, $bound(self, "LIMITS")), flight__place_problems($bound(self, "at"), $bound(self, "position"))));
}
get force() {
const self = this; 
return $mul($mul($mul($mul(self.count, self.width), self.thickness), self.pressure), self.friction);
}
}
$sig(CleanerResistance, ["at", "position", "width", "thickness", "pressure", "friction", "count"], false, {at: () => "head", position: () => null, friction: () => 0.6, count: () => 1});
class DrivePull extends $Object {
}
$sig(DrivePull, ["pulley", "share", "entry", "exit"], false, {});
class state$State extends $Object {
get pull() {
const self = this; 
return $b.sum((function* () { for (const resistance of $iter(self.resistances)) { yield resistance.total; } })());
}
get highest() {
const self = this; let ends;

(ends = [self.head, self.tail, self.entry, self.exit]);
return $b.max([...$iter(ends), ...$iter((function* () { for (const p of $iter(self.points)) { yield $b.max($bound(p, "before"), $bound(p, "after")); } })())]);
}
slack_problem() {
const self = this; let lowest, message, remedy, spot, where;

(lowest = self.lowest);
if ((lowest > 0.0)) {
return null;
}
(where = (($in(lowest, [self.entry, self.exit])) ? "at the drive pulley" : "at the far end"));
if (($b.len(new Set((function* () { for (const stretch of $iter(self.stretches)) { yield stretch.flight; } })())) > 3)) {
(spot = alike__least($bound(self, "points"), ((p) => $b.min($bound(p, "before"), $bound(p, "after")))));
(where = ("" + "at " + $str(spot.name) + " (" + $str(spot.strand) + ")"));
}
(message = ("" + "leaves " + $str(display__display(lowest, "force")) + " " + $str(where) + " in load case " + $str(self.name)));
(remedy = "Give a larger take-up tension.");
return new Problem(message, remedy, undefined, "take_up_tension");
}
get lowest() {
const self = this; let ends;

(ends = [self.head, self.tail, self.entry, self.exit]);
return $b.min([...$iter(ends), ...$iter((function* () { for (const p of $iter(self.points)) { yield $b.min($bound(p, "before"), $bound(p, "after")); } })())]);
}
}
$sig(state$State, ["name", "kind", "resistances", "head", "tail", "entry", "exit", "acceleration", "points", "stretches", "drives", "standstill"], false, {acceleration: () => 0.0, points: () => [], stretches: () => [], drives: () => [], standstill: () => null});
class Resistance extends $Object {
get total() {
const self = this; 
return $add(self.carrying, self.returning);
}
}
$sig(Resistance, ["name", "carrying", "returning", "source"], false, {});
class BeltPoint extends $Object {
}
$sig(BeltPoint, ["strand", "position", "name", "kind", "before", "after"], false, {});
class Stretch extends $Object {
}
$sig(Stretch, ["flight", "strand", "start", "end", "least", "forces", "driven", "mass"], false, {});
class Standstill extends $Object {
}
$sig(Standstill, ["slope", "friction"], false, {});
class OneOrMore extends Kind {
read(raw, place, report) {
const self = this; 
if (!$truth($b.isinstance(raw, "list"))) {
return [self.kind.read(raw, place, report)];
}
return new Rows($bound(self, "kind"), 1, $bound(self, "most")).read(raw, place, report);
}
}
$sig(OneOrMore, ["kind", "most"], false, {most: () => 50});
class ElasticPlastic extends FrictionLaw {
__post_init__() {
const self = this; let k, mu;
([mu, k] = [self.friction_coefficient, self.stiffness]);
base__check(simple___is_friction(mu), [(0.0 < k && k < Infinity), "stiffness", ("" + $format(k, ("" + "g")) + " Pa/m"), ("" + "the stiffness " + $str("must be positive and finite"))]);
}

compact() {
const self = this; let c;

(c = [self.friction_coefficient, 1.0, 0.0, (1.0 / self.stiffness)]);
return new CompactLaw(0, simple___edges($bound(self, "tested")), c, undefined, (1.0 / self.stiffness));
}
steepest_fall() {
const self = this; 
return 0.0;
}
_scaled(friction, slip) {
const self = this; return $replaced(self, new Map([["stiffness", ($mul(self.stiffness, friction) / slip)], ["friction_coefficient", $mul(self.friction_coefficient, friction)]]));
}
}
$sig(ElasticPlastic, ["slip_includes", "stiffness", "friction_coefficient", "tested"], false, {slip_includes: () => null, tested: () => null});
class Profile extends Kind {
$init(dimension, diameters = false) {
const self = this; let entries, words;
([self.dimension, self.diameters] = [dimension, diameters]);
(self.rows = new Rows(new _Pair(dimension), 0, 500));
(entries = [new Entry("rows", "Pairs of position, 0 in the middle of the belt, and value.", $bound(self, "rows")), new Entry("crown", "Height of a parabola in the middle over the edges of the belt.", new Quantity(dimension)), new Entry("factor", "Factor on all values: how much of the profile there is.", new Quantity("number", new Limit("number", undefined, 100.0))), new Entry("uncertainty", "Standard uncertainty of the values.", new Quantity(dimension, new Limit(dimension)))]);
if ($truth(diameters)) {
(words = "Whether the values are on radius (if left out) or on diameter.");
$m.append(entries, new Entry("on", words, new Choice(["radius", "diameter"])));
}
(self.within = new TextOr($bound(self, "rows"), $call(tables$Table, ["Profile", ...$iter(entries)], [["on_one_line", true]])));
}
read(raw, place, report) {
const self = this; let built, crown, factor, found, half, heights, mean, on, read, rows, table, values;

(found = $b.len($bound(report, "problems")));
(read = self.within.read(raw, place, report));
if (((read === $ca9ba) || ($b.len($bound(report, "problems")) > found))) {
return $ca9ba;
}
(table = ($truth($b.isinstance(read, Record)) ? read : $map([["rows", read]])));
([rows, on] = [$m.get(table, "rows", []), $m.get(table, "on", "radius")]);
if ((!$truth(rows) && (!$in("crown", table)))) {
return null;
}
([half, factor] = [(($eq(on, "diameter")) ? 0.5 : 1.0), $m.get(table, "factor", 1.0)]);
(values = [...(function* () { for (const [_, value] of $iter(rows)) { yield $mul(half, value); } })()]);
if ((($eq(on, "diameter")) && $truth(values) && ($b.min(values) > 0.1))) {
(mean = ($b.sum(values) / $b.len(values)));
(values = [...(function* () { for (const value of $iter(values)) { yield $sub(value, mean); } })()]);
}
(crown = $mul($mul(factor, half), $m.get(table, "crown", 0.0)));
(values = [...(function* () { for (const value of $iter(values)) { yield $mul(factor, value); } })()]);
(heights = [...$iter(values), crown]);
if (($truth(self.diameters) && !$truth(self._deviations(heights, half, place, report)))) {
return $ca9ba;
}
(built = report.tried((() => new WidthProfile($b.tuple((function* () { for (const [y, _] of $iter(rows)) { yield y; } })()), $b.tuple(values), crown, (($in("uncertainty", table)) ? $mul($mul(factor, half), $at(table, "uncertainty")) : null))), place));
return ((built == null) ? $ca9ba : built);
}
_deviations(values, half, place, report) {
const self = this; let worst;

(worst = $b.max(values, $k({key: $b.abs, default: 0.0})));
if (($b.abs(worst) <= 0.1)) {
return true;
}
report.add(place, ("" + "must be a deviation of radius up to " + $str(display__display(0.1, "length"))), "Correct it, or write on = \"diameter\".", quantity_text__quantity_text((worst / half), "length"));
return false;
}
}
class _Pair extends Kind {
$init(dimension) {
const self = this; (self.kinds = [new Quantity("length"), new Quantity(dimension)]);
}
read(raw, place, report) {
const self = this; let pair;
if ((!$truth($b.isinstance(raw, "list")) || (!$eq($b.len(raw), 2)))) {
$method(report, "add", [place, "must be a pair, position and value"], [["value", raw]]);
return $ca9ba;
}
(pair = [...(function* () { for (const [kind, item, what] of $iter($b.zip($bound(self, "kinds"), raw, ["position", "value"], $k({strict: true})))) { yield kind.read(item, [...$iter(place), what], report); } })()]);
return (($in($ca9ba, pair)) ? $ca9ba : $b.tuple(pair));
}
}
class GrippingPulley extends $Object {
__post_init__() {
const self = this; limits__raise_all(limits__limit_problems(self, $bound(self, "LIMITS")));
}
}
$sig(GrippingPulley, ["distance"], false, {});
class Count extends Kind {
read(raw, place, report) {
const self = this; let message, whole;

(whole = $and($b.isinstance(raw, "int"), () => !$truth($b.isinstance(raw, "bool"))));
if (($truth(whole) && (self.least <= raw && raw <= self.most))) {
return raw;
}
(message = ("" + "must be a whole number from " + $str(self.least) + " to " + $str(self.most)));
$method(report, "add", [place, message], [["value", raw]]);
return $ca9ba;
}
}
$sig(Count, ["least", "most"], false, {});
class Misplaced extends $Tuple {
}
$sig(Misplaced, ["keys", "message", "remedy", "owner"], false, {});
class Elsewhere extends Kind {
read(raw, place, report) {
const self = this; 
return raw;
}
}
$sig(Elsewhere, [], false, {});
class Slope extends Quantity {
read(raw, place, report) {
const self = this; let message, rise;

try {
(rise = parse__parse_quantity(raw, "number"));
} catch ($error) {
if ($error instanceof InputError) {
return super.read(raw, place, report);
} else throw $error;
}
if (($b.abs(rise) > 1.0)) {
(message = "must be an angle, or a rise over run up to 100 %");
report.add(place, message, "Write \"2 deg\" or \"3.5 %\".", raw);
return $ca9ba;
}
return $math.atan(rise);
}
}
$sig(Slope, ["dimension", "limit"], false, {limit: () => null});
class LoadedFlights extends Kind {
read(raw, place, report) {
const self = this; 
return ($truth($b.isinstance(raw, "list")) ? self.names.read(raw, place, report) : new Choice($c28af).read(raw, place, report));
}
}
$sig(LoadedFlights, [], false, {});
class Either extends Kind {
read(raw, place, report) {
const self = this; let kind, value;

for (kind of $iter([self.first, self.second])) {
try {
parse__parse_quantity(raw, $bound(kind, "dimension"));
} catch ($error) {
if ($error instanceof InputError) {
continue;
} else throw $error;
}
(value = kind.read(raw, place, report));
return ((value === $ca9ba) ? $ca9ba : [kind.dimension, value]);
}
$method(report, "add", [place, ("" + "must be " + $str(self.words))], [["value", raw]]);
return $ca9ba;
}
}
$sig(Either, ["first", "second", "words"], false, {});
class SpeedList extends Kind {
read(raw, place, report) {
const self = this; 
if (($eq(raw, "equal"))) {
return "equal";
}
if ($truth($b.isinstance(raw, "str"))) {
$method(report, "add", [place, ("" + "must be \"" + $str("equal") + "\" or an array of speeds")], [["value", raw]]);
return $ca9ba;
}
return self.rows.read(raw, place, report);
}
}
$sig(SpeedList, [], false, {});
class _OfClass extends Kind {
read(raw, place, report) {
const self = this; 
throw $TypeError;
}
}
const $c38db = ["of", "misplaced", "entries", "_known"];
const $cc442 = ["key", "kind", "required", "alias", "example", "attribute", "unless"];
const $cd20a = ["dimension", "limit"];
const $c0afb = $made(Quantity, $cd20a, ["number", null]);
const $cb73a = $made(Entry, $cc442, ["format", $c0afb, true, "", "format = 1", "format", ""]);
const $ceae0 = ["longest", "lines"];
const $ccf8f = $made(Text, $ceae0, [200, false]);
const $c34bd = $made(Entry, $cc442, ["title", $ccf8f, false, "", "", "title", ""]);
const $c7b03 = $made(Text, $ceae0, [5000, true]);
const $ce3f29 = $made(Entry, $cc442, ["description", $c7b03, false, "", "", "description", ""]);
const $cf70d = ["dimension", "least", "most", "open", "rigid"];
const $c2680 = $made(Limit, $cf70d, ["length", 0.0, 1.0, true, false]);
const $ce647 = $made(Quantity, $cd20a, ["length", $c2680]);
const $cb10e = $made(Entry, $cc442, ["creep_limit", $ce647, false, "", "", "creep_limit", ""]);
const $cf6b7 = ["kind", "most"];
const $cea31 = ["text", "table"];
const $c4a10 = ["longest"];
const $cd35f = $made(Name, $c4a10, [60]);
const $ca26a = $made(Name, $c4a10, [60]);
const $c7314 = $made(Entry, $cc442, ["name", $ca26a, true, "", "", "name", ""]);
const $cd2d2 = $made(Limit, $cf70d, ["number", 0.0, 2.0, true, false]);
const $ceac4 = $made(Quantity, $cd20a, ["number", $cd2d2]);
const $ca34d5 = $made(Entry, $cc442, ["friction_factor", $ceac4, false, "", "", "factor", ""]);
const $c6a0b = $made(ByName, $cf6b7, [$ceac4, 200]);
const $c4bd7 = $made(Entry, $cc442, ["friction_factors", $c6a0b, false, "", "", "friction_factors", ""]);
const $c322f = ["options", "others"];
const $c3465 = ["DIN 22101", "practice"];
const $cd1e1 = new Map([]);
const $c0782 = $made(Choice, $c322f, [$c3465, $cd1e1]);
const $ce3ac = $made(Entry, $cc442, ["standard", $c0782, false, "", "", "standard", ""]);
const $c375d = ["measured", "published", "calibrated", "illustrative", "given"];
const $c2f62 = new Map([]);
const $c7aba = $made(Choice, $c322f, [$c375d, $c2f62]);
const $c4f19 = $made(Entry, $cc442, ["kind", $c7aba, true, "", "", "kind", ""]);
const $ccbaa = $made(Text, $ceae0, [500, false]);
const $c57e7 = $made(Entry, $cc442, ["source", $ccbaa, false, "", "", "source", ""]);
const $c7f21 = $made(Text, $ceae0, [60, false]);
const $caef5 = $made(Entry, $cc442, ["date", $c7f21, false, "", "", "date", ""]);
const $cd050 = $made(Text, $ceae0, [1000, false]);
const $cd519 = $made(Entry, $cc442, ["note", $cd050, false, "", "", "note", ""]);
const $c085d = [$c4f19, $c57e7, $caef5, $cd519];
const $cc3a5 = new Map([["kind", $c4f19], ["source", $c57e7], ["date", $caef5], ["note", $cd519]]);
const $cc542 = $made(tables$Table, $c38db, [Provenance, null, $c085d, $cc3a5]);
const $c18ea = $made(Entry, $cc442, ["provenance", $cc542, false, "", "", "provenance", ""]);
const $c3411 = [$c7314, $ca34d5, $c4bd7, $ce3ac, $c18ea];
const $c1628 = new Map([["name", $c7314], ["friction_factor", $ca34d5], ["friction_factors", $c4bd7], ["standard", $ce3ac], ["provenance", $c18ea]]);
const $c0bb9 = $made(tables$Table, $c38db, [Condition, null, $c3411, $c1628]);
const $c6e45 = $made(TextOr, $cea31, [$cd35f, $c0bb9]);
const $c317e = $made(OneOrMore, $cf6b7, [$c6e45, 8]);
const $c750b = $made(Entry, $cc442, ["condition", $c317e, false, "", "", "condition", ""]);
const $c3008 = $made(Name, $c4a10, [60]);
const $c3ef1 = $made(Entry, $cc442, ["preset", $c3008, false, "", "", "preset", ""]);
const $c2f46 = $made(Name, $c4a10, [60]);
const $c801a = $made(Entry, $cc442, ["name", $c2f46, false, "", "", "name", ""]);
const $c291d = $made(Text, $ceae0, [60, false]);
const $c7e52 = $made(Entry, $cc442, ["kind", $c291d, false, "", "", "kind", ""]);
const $c1da4 = $made(Limit, $cf70d, ["length", 0.001, 10.0, false, false]);
const $c01ab = $made(Quantity, $cd20a, ["length", $c1da4]);
const $cd329 = $made(Entry, $cc442, ["width", $c01ab, true, "", "", "width", ""]);
const $c6a10 = ["word", "kind", "meaning"];
const $c5a26 = $made(Limit, $cf70d, ["force_per_width", 1000.0, Infinity, false, true]);
const $cebd5 = $made(Quantity, $cd20a, ["force_per_width", $c5a26]);
const $c4321 = $made(WordOr, $c6a10, ["rigid", $cebd5, Infinity]);
const $c0833 = $made(Entry, $cc442, ["modulus", $c4321, false, "", "", "modulus", ""]);
const $c4b77 = $made(Elongation, [], []);
const $cb156 = $made(Entry, $cc442, ["elongation", $c4b77, false, "", "", "elongation", ""]);
const $c4bc3 = $made(Limit, $cf70d, ["force_per_width", 0.0, Infinity, true, false]);
const $c5a41 = $made(Quantity, $cd20a, ["force_per_width", $c4bc3]);
const $cb059 = $made(Entry, $cc442, ["rating", $c5a41, false, "", "", "rating", ""]);
const $c3eaf = $made(Limit, $cf70d, ["force_per_width", 0.0, Infinity, true, false]);
const $cae9b = $made(Quantity, $cd20a, ["force_per_width", $c3eaf]);
const $c8c7e = $made(Entry, $cc442, ["strength", $cae9b, false, "", "", "strength", ""]);
const $c3769 = ["dynamic", "static"];
const $cea8d = new Map([]);
const $c52cc = $made(Choice, $c322f, [$c3769, $cea8d]);
const $cd900 = $made(Entry, $cc442, ["modulus_test", $c52cc, false, "", "", "modulus_test", ""]);
const $ce552 = ["kind", "least", "most"];
const $c7fcc = ["dimension", "limit", "most"];
const $c924e = $made(Limit, $cf70d, ["number", 0.0, 1.0, false, false]);
const $cbbb2 = $made(Percent, $c7fcc, ["number", $c924e, 1.0]);
const $cd2af = $made(Rows, $ce552, [$cbbb2, 2, 2]);
const $c34a0 = $made(Entry, $cc442, ["modulus_loads", $cd2af, false, "", "", "modulus_loads", ""]);
const $c45b0 = $made(Limit, $cf70d, ["speed", 0.0, 1000.0, true, false]);
const $cbc50 = $made(Quantity, $cd20a, ["speed", $c45b0]);
const $c2745 = $made(Entry, $cc442, ["speed", $cbc50, false, "", "", "speed", ""]);
const $cfb5f = $made(Limit, $cf70d, ["number", 1.0, 10.0, false, false]);
const $c2c6c = $made(Quantity, $cd20a, ["number", $cfb5f]);
const $c5eeb = $made(Entry, $cc442, ["momentary_factor", $c2c6c, false, "", "", "momentary_factor", ""]);
const $cbc30 = $made(Limit, $cf70d, ["length", 0.0, Infinity, true, false]);
const $cb28b = $made(Quantity, $cd20a, ["length", $cbc30]);
const $cfe48 = $made(Entry, $cc442, ["least_pulley_diameter", $cb28b, false, "", "", "least_pulley_diameter", ""]);
const $cf3a1 = $made(Limit, $cf70d, ["pressure", 0.0, Infinity, true, false]);
const $cc07a = $made(Quantity, $cd20a, ["pressure", $cf3a1]);
const $c87e9 = $made(Entry, $cc442, ["largest_wrap_pressure", $cc07a, false, "", "", "largest_wrap_pressure", ""]);
const $cd676 = $made(Limit, $cf70d, ["force_per_width", 1.0, 1000000000.0, false, false]);
const $c49e6 = $made(Quantity, $cd20a, ["force_per_width", $cd676]);
const $c4ee8 = $made(Entry, $cc442, ["in_plane_shear_stiffness", $c49e6, false, "", "", "in_plane_shear_stiffness", ""]);
const $cbe31 = $made(Limit, $cf70d, ["length", 0.0, 0.06, false, false]);
const $c9861 = $made(Quantity, $cd20a, ["length", $cbe31]);
const $cc066 = $made(Entry, $cc442, ["pulley_cover", $c9861, false, "", "", "pulley_cover", ""]);
const $ca3d0 = $made(Limit, $cf70d, ["length", 0.0, 0.06, false, false]);
const $ce9d5 = $made(Quantity, $cd20a, ["length", $ca3d0]);
const $c6210 = $made(Entry, $cc442, ["carry_cover", $ce9d5, false, "", "", "carry_cover", ""]);
const $c9b33 = $made(Limit, $cf70d, ["length", 0.0, 0.06, true, false]);
const $ccdee = $made(Quantity, $cd20a, ["length", $c9b33]);
const $cc24c = $made(Entry, $cc442, ["carcass", $ccdee, false, "", "", "carcass", ""]);
const $cbf1f = $made(Limit, $cf70d, ["length", 0.0, 0.06, true, false]);
const $ccd43 = $made(Quantity, $cd20a, ["length", $cbf1f]);
const $c91f6 = $made(Entry, $cc442, ["thickness", $ccd43, false, "", "", "thickness", ""]);
const $c975b = $made(Limit, $cf70d, ["pressure", 100000.0, 100000000.0, false, true]);
const $c081b = $made(Quantity, $cd20a, ["pressure", $c975b]);
const $cc736 = $made(WordOr, $c6a10, ["rigid", $c081b, Infinity]);
const $c182a = $made(Entry, $cc442, ["cover_shear_modulus", $cc736, false, "", "", "cover_shear_modulus", ""]);
const $c7e3d = $made(Limit, $cf70d, ["length", 0.0, 0.06, true, false]);
const $c7195 = $made(Quantity, $cd20a, ["length", $c7e3d]);
const $c9939 = $made(Entry, $cc442, ["cord_diameter", $c7195, false, "", "", "cord_diameter", ""]);
const $c26ab = $made(Limit, $cf70d, ["length", 0.0, 0.1, true, false]);
const $c2854 = $made(Quantity, $cd20a, ["length", $c26ab]);
const $c158e = $made(Entry, $cc442, ["cord_pitch", $c2854, false, "", "", "cord_pitch", ""]);
const $ce1b5 = $made(Limit, $cf70d, ["mass_per_length", 0.0, 1000000.0, true, false]);
const $c8beb = $made(Quantity, $cd20a, ["mass_per_length", $ce1b5]);
const $cea14 = $made(Entry, $cc442, ["mass", $c8beb, false, "", "", "mass", ""]);
const $c7d9a = $made(Limit, $cf70d, ["number", 0.0, 1.0, false, false]);
const $cf7b4 = $made(Percent, $c7fcc, ["number", $c7d9a, 1.0]);
const $c7c25 = $made(ByName, $cf6b7, [$cf7b4, 200]);
const $c3a33 = $made(Entry, $cc442, ["uncertainty", $c7c25, false, "", "", "uncertainty", ""]);
const $c69c3 = $made(Entry, $cc442, ["provenance", $cc542, false, "", "", "provenance", ""]);
const $c0309 = $made(ByName, $cf6b7, [$cc542, 200]);
const $c9b00 = $made(Entry, $cc442, ["sources", $c0309, false, "", "", "sources", ""]);
const $c75bc = [$c3ef1, $c801a, $c7e52, $cd329, $c0833, $cb156, $cb059, $c8c7e, $cd900, $c34a0, $c2745, $c5eeb, $cfe48, $c87e9, $c4ee8, $cc066, $c6210, $cc24c, $c91f6, $c182a, $c9939, $c158e, $cea14, $c3a33, $c69c3, $c9b00];
const $c87a7 = new Map([["preset", $c3ef1], ["name", $c801a], ["kind", $c7e52], ["width", $cd329], ["modulus", $c0833], ["elongation", $cb156], ["rating", $cb059], ["strength", $c8c7e], ["modulus_test", $cd900], ["modulus_loads", $c34a0], ["speed", $c2745], ["momentary_factor", $c5eeb], ["least_pulley_diameter", $cfe48], ["largest_wrap_pressure", $c87e9], ["in_plane_shear_stiffness", $c4ee8], ["pulley_cover", $cc066], ["carry_cover", $c6210], ["carcass", $cc24c], ["thickness", $c91f6], ["cover_shear_modulus", $c182a], ["cord_diameter", $c9939], ["cord_pitch", $c158e], ["mass", $cea14], ["uncertainty", $c3a33], ["provenance", $c69c3], ["sources", $c9b00]]);
const $c808d = $made(tables$Table, $c38db, [Belt, null, $c75bc, $c87a7]);
const $cfe86 = $made(Entry, $cc442, ["belt", $c808d, true, "", "a [belt] table", "belt", ""]);
const $c8d5c = $made(Name, $c4a10, [60]);
const $c0948 = $made(Entry, $cc442, ["name", $c8d5c, true, "", "name = \"head\"", "name", ""]);
const $cd632 = $made(Limit, $cf70d, ["length", 0.001, 1000.0, false, false]);
const $cf827 = $made(Quantity, $cd20a, ["length", $cd632]);
const $c75c1 = $made(Entry, $cc442, ["diameter", $cf827, true, "", "", "diameter", ""]);
const $c1cfe = $made(Limit, $cf70d, ["angle", 0.017453292519943295, 12.566370614359172, false, false]);
const $c8a05 = $made(Quantity, $cd20a, ["angle", $c1cfe]);
const $ce003 = $made(Entry, $cc442, ["wrap_angle", $c8a05, true, "wrap", "", "wrap_angle", "belt_path"]);
const $c9b84 = $made(Limit, $cf70d, ["length", -100000.0, 100000.0, false, false]);
const $c34e8 = $made(Quantity, $cd20a, ["length", $c9b84]);
const $c36c0 = $made(Entry, $cc442, ["x", $c34e8, true, "", "", "x", ""]);
const $cb660 = $made(Quantity, $cd20a, ["length", $c9b84]);
const $c04f3 = $made(Entry, $cc442, ["y", $cb660, true, "", "", "y", ""]);
const $c6dc1 = ["clockwise", "counterclockwise"];
const $c8698 = new Map([]);
const $c5a261 = $made(Choice, $c322f, [$c6dc1, $c8698]);
const $c3629 = $made(Entry, $cc442, ["turn", $c5a261, false, "", "", "turn", ""]);
const $c250c = $made(Quantity, $cd20a, ["length", $c9b84]);
const $c0cdc = $made(Entry, $cc442, ["x", $c250c, true, "", "", "x", ""]);
const $cfc14 = $made(Quantity, $cd20a, ["length", $c9b84]);
const $c030d = $made(Entry, $cc442, ["y", $cfc14, true, "", "", "y", ""]);
const $c3de9 = $made(Limit, $cf70d, ["length", 0.0, 1000.0, false, false]);
const $cc5e2 = $made(Quantity, $cd20a, ["length", $c3de9]);
const $c08a4 = $made(Entry, $cc442, ["diameter", $cc5e2, false, "", "", "diameter", ""]);
const $c9465 = [$c0cdc, $c030d, $c08a4, $c3629];
const $c3c72 = new Map([["x", $c0cdc], ["y", $c030d], ["diameter", $c08a4], ["turn", $c3629]]);
const $c59ff = $made(tables$Table, $c38db, [Point, null, $c9465, $c3c72]);
const $c0652 = $made(Entry, $cc442, ["before", $c59ff, true, "", "a table with x and y", "before", ""]);
const $c1a06 = $made(Entry, $cc442, ["after", $c59ff, true, "", "a table with x and y", "after", ""]);
const $c530a = [$c36c0, $c04f3, $c3629, $c0652, $c1a06];
const $cd928 = new Map([["x", $c36c0], ["y", $c04f3], ["turn", $c3629], ["before", $c0652], ["after", $c1a06]]);
const $c30aa = $made(tables$Table, $c38db, [Point, null, $c530a, $cd928]);
const $c65eb = $made(Entry, $cc442, ["belt_path", $c30aa, false, "", "", "belt_path", ""]);
const $c0ecb = $made(Name, $c4a10, [500]);
const $c8cae = $made(Name, $c4a10, [500]);
const $cfab4 = $made(Entry, $cc442, ["preset", $c8cae, false, "", "", "preset", ""]);
const $c3d1c = $made(Name, $c4a10, [60]);
const $c7e8f = $made(Entry, $cc442, ["name", $c3d1c, false, "", "", "name", ""]);
const $c5207 = $made(Text, $ceae0, [200, false]);
const $cd66f = $made(Entry, $cc442, ["title", $c5207, false, "", "", "title", ""]);
const $c8ef3 = $made(Text, $ceae0, [5000, true]);
const $cc3a1 = $made(Entry, $cc442, ["description", $c8ef3, false, "", "", "description", ""]);
const $c504b = ["bare", "rubber", "polyurethane", "ceramic"];
const $c620d = new Map([]);
const $c7d4c = $made(Choice, $c322f, [$c504b, $c620d]);
const $c5462 = $made(Entry, $cc442, ["surface", $c7d4c, false, "", "", "surface", ""]);
const $c3f61 = $made(Limit, $cf70d, ["length", 0.0, 1.0, false, false]);
const $cc797 = $made(Quantity, $cd20a, ["length", $c3f61]);
const $ca06f = $made(Entry, $cc442, ["thickness", $cc797, false, "", "", "thickness", ""]);
const $cc7a6 = $made(Limit, $cf70d, ["pressure", 1000.0, Infinity, false, false]);
const $ce912 = $made(Quantity, $cd20a, ["pressure", $cc7a6]);
const $c99bb = $made(Entry, $cc442, ["elastic_modulus", $ce912, false, "", "", "elastic_modulus", ""]);
const $c8b29 = $made(Limit, $cf70d, ["pressure", 1000.0, Infinity, false, true]);
const $c6e60 = $made(Quantity, $cd20a, ["pressure", $c8b29]);
const $cf24d = $made(WordOr, $c6a10, ["rigid", $c6e60, Infinity]);
const $c3ae4 = $made(Entry, $cc442, ["shear_modulus", $cf24d, false, "", "", "shear_modulus", ""]);
const $cc576 = $made(Limit, $cf70d, ["pressure", 1000.0, Infinity, false, true]);
const $cabc1 = $made(Quantity, $cd20a, ["pressure", $cc576]);
const $c76438 = $made(WordOr, $c6a10, ["rigid", $cabc1, Infinity]);
const $c3f7b = $made(Entry, $cc442, ["compression_modulus", $c76438, false, "", "", "compression_modulus", ""]);
const $c7017 = ["square", "strip"];
const $cd181 = new Map([]);
const $cd99a = $made(Choice, $c322f, [$c7017, $cd181]);
const $c2e7f = $made(Entry, $cc442, ["shape", $cd99a, false, "", "", "shape", ""]);
const $c318b = $made(Limit, $cf70d, ["length", 0.0001, 10.0, false, false]);
const $ce3ab = $made(Quantity, $cd20a, ["length", $c318b]);
const $c4c96 = $made(Entry, $cc442, ["width", $ce3ab, true, "", "", "width", ""]);
const $cd6edf = $made(Limit, $cf70d, ["length", 0.0001, 1.0, false, false]);
const $c8839 = $made(Quantity, $cd20a, ["length", $cd6edf]);
const $cbe53 = $made(Entry, $cc442, ["height", $c8839, false, "", "", "height", ""]);
const $caba4 = $made(Limit, $cf70d, ["number", 0.0, 10.0, false, false]);
const $ca4ad = $made(Quantity, $cd20a, ["number", $caba4]);
const $c03a0 = $made(Entry, $cc442, ["stiffening", $ca4ad, false, "", "", "stiffening", ""]);
const $cbc3c = $made(Limit, $cf70d, ["number", 0.01, 1.0, false, false]);
const $c09a5 = $made(Quantity, $cd20a, ["number", $cbc3c]);
const $ced2e = $made(Entry, $cc442, ["contact_fraction", $c09a5, false, "", "", "contact_fraction", ""]);
const $cc4be = [$c2e7f, $c4c96, $cbe53, $c03a0, $ced2e];
const $c23e9 = new Map([["shape", $c2e7f], ["width", $c4c96], ["height", $cbe53], ["stiffening", $c03a0], ["contact_fraction", $ced2e]]);
const $c52db = $made(tables$Table, $c38db, [Block, null, $cc4be, $c23e9]);
const $c29e5 = $made(Entry, $cc442, ["block", $c52db, false, "", "", "block", ""]);
const $c7180 = $made(Limit, $cf70d, ["wear_coefficient", 0.0, 1.0, false, false]);
const $c4bc9 = $made(Quantity, $cd20a, ["wear_coefficient", $c7180]);
const $c2d43 = $made(Entry, $cc442, ["wear_coefficient", $c4bc9, false, "", "", "wear_coefficient", ""]);
const $c36e6 = $made(Limit, $cf70d, ["number", 0.0, 1.0, false, false]);
const $c3592 = $made(Quantity, $cd20a, ["number", $c36e6]);
const $c3692 = $made(Entry, $cc442, ["belt_energy_share", $c3592, false, "", "", "belt_energy_share", ""]);
const $c95d2 = $made(Limit, $cf70d, ["pressure", 0.0, Infinity, true, false]);
const $cd501 = $made(Quantity, $cd20a, ["pressure", $c95d2]);
const $c1d96 = $made(Entry, $cc442, ["bond_strength", $cd501, false, "", "", "bond_strength", ""]);
const $cc04b = $made(Limit, $cf70d, ["pressure", 0.0, Infinity, true, false]);
const $c060b = $made(Quantity, $cd20a, ["pressure", $cc04b]);
const $c9f8f = $made(Entry, $cc442, ["fatigue_limit", $c060b, false, "", "", "fatigue_limit", ""]);
const $c78fc = $made(Limit, $cf70d, ["number", 0.0, Infinity, false, false]);
const $c07b0 = $made(Quantity, $cd20a, ["number", $c78fc]);
const $cfb57 = $made(Entry, $cc442, ["material", $c07b0, true, "", "", "material", ""]);
const $c92d0 = $made(Limit, $cf70d, ["number", 0.0, Infinity, false, false]);
const $c1a79 = $made(Quantity, $cd20a, ["number", $c92d0]);
const $c0d77 = $made(Entry, $cc442, ["installation", $c1a79, true, "", "", "installation", ""]);
const $c4a29 = $made(Name, $c4a10, [12]);
const $c236d = $made(Entry, $cc442, ["currency", $c4a29, true, "", "", "currency", ""]);
const $c0c54 = $made(Limit, $cf70d, ["area", 0.0, Infinity, true, false]);
const $cb8121 = $made(Quantity, $cd20a, ["area", $c0c54]);
const $c6221 = $made(Entry, $cc442, ["area", $cb8121, true, "", "", "area", ""]);
const $c72ba = $made(Quantity, $cd20a, ["number", null]);
const $c8efb = $made(Rows, $ce552, [$c72ba, 2, 2]);
const $cf24b = $made(Entry, $cc442, ["life_years", $c8efb, true, "", "", "life_years", ""]);
const $cf727 = [$cfb57, $c0d77, $c236d, $c6221, $cf24b];
const $c845c = new Map([["material", $cfb57], ["installation", $c0d77], ["currency", $c236d], ["area", $c6221], ["life_years", $cf24b]]);
const $c5864 = $made(tables$Table, $c38db, [Cost, null, $cf727, $c845c]);
const $c03097 = $made(Entry, $cc442, ["cost", $c5864, false, "", "", "cost", ""]);
const $c540e = $made(Limit, $cf70d, ["speed", 0.0, Infinity, true, false]);
const $c0a1c = $made(Quantity, $cd20a, ["speed", $c540e]);
const $c2480 = $made(Entry, $cc442, ["slip_speed", $c0a1c, false, "", "", "slip_speed", ""]);
const $cc611 = $made(Limit, $cf70d, ["temperature", 0.0, Infinity, false, false]);
const $c68a4 = $made(Quantity, $cd20a, ["temperature", $cc611]);
const $c2fb3 = $made(Entry, $cc442, ["temperature", $c68a4, false, "", "", "temperature", ""]);
const $c82d0 = $made(Name, $c4a10, [60]);
const $cf002 = $made(Entry, $cc442, ["condition", $c82d0, true, "", "", "condition", ""]);
const $cf35d = $made(Limit, $cf70d, ["number", 0.0, 10.0, true, false]);
const $cbaec = $made(Quantity, $cd20a, ["number", $cf35d]);
const $c1304 = $made(Entry, $cc442, ["factor", $cbaec, true, "", "", "factor", ""]);
const $c60f2 = $made(Entry, $cc442, ["provenance", $cc542, true, "", "", "provenance", ""]);
const $c6e0e = [$cf002, $c1304, $c60f2];
const $c4d20 = new Map([["condition", $cf002], ["factor", $c1304], ["provenance", $c60f2]]);
const $c49a9 = $made(tables$Table, $c38db, [ConditionFactor, null, $c6e0e, $c4d20]);
const $c611f = $made(Rows, $ce552, [$c49a9, 0, 20]);
const $c7315 = $made(Entry, $cc442, ["condition_factor", $c611f, false, "", "", "condition_factor", ""]);
const $c3ebe = ["tag", "tables"];
const $c94b3 = ["integral-log"];
const $c9c59 = new Map([]);
const $c646a = $made(Choice, $c322f, [$c94b3, $c9c59]);
const $c813f2 = $made(Entry, $cc442, ["kind", $c646a, true, "", "", "kind", ""]);
const $c3f7f = $made(Name, $c4a10, [60]);
const $cb8a8 = $made(Entry, $cc442, ["condition", $c3f7f, false, "", "", "condition", ""]);
const $cd10e = $made(Entry, $cc442, ["provenance", $cc542, false, "", "", "provenance", ""]);
const $ce384 = $made(Entry, $cc442, ["condition_factor", $cbaec, false, "", "", "condition_factor", ""]);
const $cca84 = $made(Entry, $cc442, ["condition_source", $cc542, false, "", "", "condition_source", ""]);
const $cbdba = $made(Name, $c4a10, [120]);
const $c6426 = $made(Rows, $ce552, [$cbdba, 1, 1000]);
const $c2c4e = $made(Entry, $cc442, ["parameters", $c6426, true, "", "", "parameters", ""]);
const $c8780 = $made(Rows, $ce552, [$c72ba, 1, 1000]);
const $c13d7 = $made(Entry, $cc442, ["values", $c8780, true, "", "", "values", ""]);
const $c063f = $made(Rows, $ce552, [$c72ba, 1, 1000]);
const $c63caa2 = $made(Rows, $ce552, [$c063f, 1, 1000]);
const $c6869 = $made(Entry, $cc442, ["covariance", $c63caa2, true, "", "", "covariance", ""]);
const $ca894 = $made(Limit, $cf70d, ["number", 0.0, Infinity, false, false]);
const $c378e = $made(Quantity, $cd20a, ["number", $ca894]);
const $c1e1b = $made(Entry, $cc442, ["residual_noise", $c378e, false, "", "", "residual_noise", ""]);
const $c9431 = $made(Limit, $cf70d, ["number", 1.0, Infinity, false, false]);
const $c6d9f = $made(Quantity, $cd20a, ["number", $c9431]);
const $c7724 = $made(Entry, $cc442, ["coverage_factor", $c6d9f, false, "", "", "coverage_factor", ""]);
const $c6745c = $made(Text, $ceae0, [60, false]);
const $c3ee7 = $made(Entry, $cc442, ["date", $c6745c, false, "", "", "date", ""]);
const $ce0c1 = $made(Text, $ceae0, [500, false]);
const $c838d = $made(Entry, $cc442, ["method", $ce0c1, false, "", "", "method", ""]);
const $c4d9f = $made(Text, $ceae0, [2000, true]);
const $cf44f = $made(Rows, $ce552, [$c4d9f, 0, 50]);
const $c7094 = $made(Entry, $cc442, ["misfit", $cf44f, false, "", "", "misfit", ""]);
const $ca33f = $made(Text, $ceae0, [500, false]);
const $ccb4a = $made(Entry, $cc442, ["misfit_accepted", $ca33f, false, "", "", "misfit_accepted", ""]);
const $ca3d7 = [$c2c4e, $c13d7, $c6869, $c1e1b, $c7724, $c3ee7, $c838d, $c7094, $ccb4a];
const $c2f5db = new Map([["parameters", $c2c4e], ["values", $c13d7], ["covariance", $c6869], ["residual_noise", $c1e1b], ["coverage_factor", $c7724], ["date", $c3ee7], ["method", $c838d], ["misfit", $c7094], ["misfit_accepted", $ccb4a]]);
const $cb4b3 = $made(tables$Table, $c38db, [Fit, null, $ca3d7, $c2f5db]);
const $c1057 = $made(Entry, $cc442, ["fit", $cb4b3, false, "", "", "fit", ""]);
const $cc344 = ["lagging shear", "cover shear"];
const $c6641 = new Map([]);
const $cdd6d = $made(Choice, $c322f, [$cc344, $c6641]);
const $c5f64 = $made(Rows, $ce552, [$cdd6d, 0, 2]);
const $caa9e = $made(Entry, $cc442, ["slip_includes", $c5f64, false, "", "", "slip_includes", ""]);
const $c7d5b = $made(Limit, $cf70d, ["speed", 0.0, Infinity, true, false]);
const $ccdd5 = $made(Quantity, $cd20a, ["speed", $c7d5b]);
const $cd8f1 = $made(Rows, $ce552, [$ccdd5, 2, 100]);
const $cc71d = $made(Entry, $cc442, ["slip_speed", $cd8f1, true, "", "", "at", ""]);
const $cdb49 = $made(Rows, $ce552, [$cbaec, 2, 100]);
const $c268e = $made(Entry, $cc442, ["factor", $cdb49, true, "", "", "factor", ""]);
const $cb8ef = [$cc71d, $c268e, $c60f2];
const $c6635 = new Map([["slip_speed", $cc71d], ["factor", $c268e], ["provenance", $c60f2]]);
const $cd525 = $made(tables$Table, $c38db, [FrictionFactor, null, $cb8ef, $c6635]);
const $cb813 = $made(Entry, $cc442, ["slip_speed_factor", $cd525, false, "", "", "slip_speed_factor", ""]);
const $ce079 = $made(Limit, $cf70d, ["temperature", 0.0, Infinity, false, false]);
const $cde95 = $made(Quantity, $cd20a, ["temperature", $ce079]);
const $c4703 = $made(Rows, $ce552, [$cde95, 2, 100]);
const $c9fc6 = $made(Entry, $cc442, ["temperature", $c4703, true, "", "", "at", ""]);
const $c5e32 = [$c9fc6, $c268e, $c60f2];
const $ca296 = new Map([["temperature", $c9fc6], ["factor", $c268e], ["provenance", $c60f2]]);
const $c50d3 = $made(tables$Table, $c38db, [FrictionFactor, null, $c5e32, $ca296]);
const $c0aa1 = $made(Entry, $cc442, ["temperature_factor", $c50d3, false, "", "", "temperature_factor", ""]);
const $cfb99 = $made(Entry, $cc442, ["notes", $cf44f, false, "", "", "notes", ""]);
const $c81ea = $made(Limit, $cf70d, ["pressure", 0.0, 1000000000.0, true, false]);
const $c39ba = $made(Quantity, $cd20a, ["pressure", $c81ea]);
const $cd05d = $made(Rows, $ce552, [$c39ba, 2, 2]);
const $c9fcf = $made(Entry, $cc442, ["tested_pressure", $cd05d, false, "", "", "tested_pressure", ""]);
const $cb43d = $made(Limit, $cf70d, ["length", 0.0, 1.0, true, false]);
const $cbb5d = $made(Quantity, $cd20a, ["length", $cb43d]);
const $c160f = $made(Entry, $cc442, ["tested_slip", $cbb5d, false, "", "", "tested_slip", ""]);
const $cd745 = $made(Limit, $cf70d, ["speed", 0.0, Infinity, true, false]);
const $ce244 = $made(Quantity, $cd20a, ["speed", $cd745]);
const $cb799 = $made(Entry, $cc442, ["tested_slip_speed", $ce244, false, "", "", "tested_slip_speed", ""]);
const $cc15e = $made(Entry, $cc442, ["pressure", $c39ba, true, "", "", "pressure", ""]);
const $cf28f = $made(Limit, $cf70d, ["number", 0.0, 5.0, true, false]);
const $c47dc = $made(Quantity, $cd20a, ["number", $cf28f]);
const $c3799 = $made(Entry, $cc442, ["peak_friction", $c47dc, true, "", "", "peak_friction", ""]);
const $c003d = $made(Entry, $cc442, ["peak_slip", $cbb5d, true, "", "", "peak_slip", ""]);
const $c4aed = $made(Limit, $cf70d, ["per_length", -1000000.0, 0.0, false, false]);
const $cdc43 = $made(Quantity, $cd20a, ["per_length", $c4aed]);
const $c6a06 = $made(Entry, $cc442, ["post_peak_slope", $cdc43, false, "", "", "post_peak_slope", ""]);
const $c7cb0 = $made(Entry, $cc442, ["residual_friction", $c47dc, false, "", "", "residual_friction", ""]);
const $c276a = [$cc15e, $c3799, $c003d, $c6a06, $c7cb0];
const $cda66 = new Map([["pressure", $cc15e], ["peak_friction", $c3799], ["peak_slip", $c003d], ["post_peak_slope", $c6a06], ["residual_friction", $c7cb0]]);
const $c641b = $made(tables$Table, $c38db, [null, null, $c276a, $cda66]);
const $c551d = $made(Rows, $ce552, [$c641b, 1, 200]);
const $c94d6 = $made(Entry, $cc442, ["knots", $c551d, false, "", "", "knots", ""]);
const $cd02a = $made(Entry, $cc442, ["from", $c39ba, true, "", "", "from", ""]);
const $c4859 = $made(Entry, $cc442, ["to", $c39ba, true, "", "", "to", ""]);
const $cd4c0 = $made(Text, $ceae0, [300, false]);
const $c5430 = $made(Entry, $cc442, ["A", $cd4c0, true, "", "", "A", ""]);
const $cb307 = $made(Entry, $cc442, ["b", $cd4c0, true, "", "", "b", ""]);
const $cb294 = $made(Entry, $cc442, ["post_peak_slope", $cd4c0, false, "", "", "post_peak_slope", ""]);
const $cc1d4 = $made(Entry, $cc442, ["residual_friction", $cd4c0, false, "", "", "residual_friction", ""]);
const $c06b0 = [$cd02a, $c4859, $c5430, $cb307, $cb294, $cc1d4];
const $cff11 = new Map([["from", $cd02a], ["to", $c4859], ["A", $c5430], ["b", $cb307], ["post_peak_slope", $cb294], ["residual_friction", $cc1d4]]);
const $c6745 = $made(tables$Table, $c38db, [null, null, $c06b0, $cff11]);
const $cf9cc2 = $made(Rows, $ce552, [$c6745, 1, 50]);
const $c85eb = $made(Entry, $cc442, ["pieces", $cf9cc2, false, "", "", "pieces", ""]);
const $c5bec = $made(Text, $ceae0, [20, false]);
const $cea5d = $made(Entry, $cc442, ["slip_unit", $c5bec, false, "", "", "slip_unit", ""]);
const $ce3fa = $made(Text, $ceae0, [20, false]);
const $cc488 = $made(Entry, $cc442, ["pressure_unit", $ce3fa, false, "", "", "pressure_unit", ""]);
const $ccc84 = $made(Limit, $cf70d, ["number", 0.0, 0.5, false, false]);
const $c2620 = $made(Quantity, $cd20a, ["number", $ccc84]);
const $cb6ac = $made(Entry, $cc442, ["continuity", $c2620, false, "", "", "continuity", ""]);
const $cde4e = [$c813f2, $cb8a8, $cd10e, $ce384, $cca84, $c1057, $caa9e, $cb813, $c0aa1, $cfb99, $c9fcf, $c160f, $cb799, $c94d6, $c85eb, $cea5d, $cc488, $cb6ac];
const $c3ac0 = new Map([["kind", $c813f2], ["condition", $cb8a8], ["provenance", $cd10e], ["condition_factor", $ce384], ["condition_source", $cca84], ["fit", $c1057], ["slip_includes", $caa9e], ["slip_speed_factor", $cb813], ["temperature_factor", $c0aa1], ["notes", $cfb99], ["tested_pressure", $c9fcf], ["tested_slip", $c160f], ["tested_slip_speed", $cb799], ["knots", $c94d6], ["pieces", $c85eb], ["slip_unit", $cea5d], ["pressure_unit", $cc488], ["continuity", $cb6ac]]);
const $c5f9b = $made(tables$Table, $c38db, [IntegralLog, null, $cde4e, $c3ac0]);
const $cc85b = ["constant"];
const $c5f45 = new Map([]);
const $ca100 = $made(Choice, $c322f, [$cc85b, $c5f45]);
const $c4ce1 = $made(Entry, $cc442, ["kind", $ca100, true, "", "", "kind", ""]);
const $c1993 = $made(Entry, $cc442, ["friction", $c47dc, true, "", "", "friction_coefficient", ""]);
const $c0a43 = [$c4ce1, $cb8a8, $cd10e, $ce384, $cca84, $c1057, $caa9e, $cb813, $c0aa1, $cfb99, $c9fcf, $c160f, $cb799, $c1993];
const $c6433 = new Map([["kind", $c4ce1], ["condition", $cb8a8], ["provenance", $cd10e], ["condition_factor", $ce384], ["condition_source", $cca84], ["fit", $c1057], ["slip_includes", $caa9e], ["slip_speed_factor", $cb813], ["temperature_factor", $c0aa1], ["notes", $cfb99], ["tested_pressure", $c9fcf], ["tested_slip", $c160f], ["tested_slip_speed", $cb799], ["friction", $c1993]]);
const $cacce = $made(tables$Table, $c38db, [Constant, null, $c0a43, $c6433]);
const $c152d = ["elastic-plastic"];
const $c46ee = new Map([]);
const $c49c9 = $made(Choice, $c322f, [$c152d, $c46ee]);
const $c84cb = $made(Entry, $cc442, ["kind", $c49c9, true, "", "", "kind", ""]);
const $c5ab6 = $made(Limit, $cf70d, ["pressure_per_length", 0.0, 1000000000000000.0, true, false]);
const $cdc00 = $made(Quantity, $cd20a, ["pressure_per_length", $c5ab6]);
const $c8647 = $made(Entry, $cc442, ["stiffness", $cdc00, true, "", "", "stiffness", ""]);
const $c797c = [$c84cb, $cb8a8, $cd10e, $ce384, $cca84, $c1057, $caa9e, $cb813, $c0aa1, $cfb99, $c9fcf, $c160f, $cb799, $c8647, $c1993];
const $c1e9d = new Map([["kind", $c84cb], ["condition", $cb8a8], ["provenance", $cd10e], ["condition_factor", $ce384], ["condition_source", $cca84], ["fit", $c1057], ["slip_includes", $caa9e], ["slip_speed_factor", $cb813], ["temperature_factor", $c0aa1], ["notes", $cfb99], ["tested_pressure", $c9fcf], ["tested_slip", $c160f], ["tested_slip_speed", $cb799], ["stiffness", $c8647], ["friction", $c1993]]);
const $c13aa = $made(tables$Table, $c38db, [ElasticPlastic, null, $c797c, $c1e9d]);
const $c5b99 = ["power"];
const $cf5e5 = new Map([]);
const $c16e4 = $made(Choice, $c322f, [$c5b99, $cf5e5]);
const $ca02c = $made(Entry, $cc442, ["kind", $c16e4, true, "", "", "kind", ""]);
const $c79e4 = $made(Entry, $cc442, ["friction", $c47dc, true, "", "", "friction_coefficient", ""]);
const $c8dc8 = $made(Entry, $cc442, ["reference_pressure", $c39ba, true, "", "", "reference_pressure", ""]);
const $c41b9 = $made(Entry, $cc442, ["exponent", $c72ba, true, "", "", "exponent", ""]);
const $cc0a4 = [$ca02c, $cb8a8, $cd10e, $ce384, $cca84, $c1057, $caa9e, $cb813, $c0aa1, $cfb99, $c9fcf, $c160f, $cb799, $c79e4, $c8dc8, $c41b9];
const $ca42f = new Map([["kind", $ca02c], ["condition", $cb8a8], ["provenance", $cd10e], ["condition_factor", $ce384], ["condition_source", $cca84], ["fit", $c1057], ["slip_includes", $caa9e], ["slip_speed_factor", $cb813], ["temperature_factor", $c0aa1], ["notes", $cfb99], ["tested_pressure", $c9fcf], ["tested_slip", $c160f], ["tested_slip_speed", $cb799], ["friction", $c79e4], ["reference_pressure", $c8dc8], ["exponent", $c41b9]]);
const $ce558 = $made(tables$Table, $c38db, [PressurePower, null, $cc0a4, $ca42f]);
const $cb4ec = ["table"];
const $c4afd = new Map([]);
const $cdb18 = $made(Choice, $c322f, [$cb4ec, $c4afd]);
const $ce458 = $made(Entry, $cc442, ["kind", $cdb18, true, "", "", "kind", ""]);
const $cd2e1 = $made(Limit, $cf70d, ["length", 0.0, 1.0, false, false]);
const $c9271 = $made(Quantity, $cd20a, ["length", $cd2e1]);
const $cb559 = $made(Rows, $ce552, [$c9271, 2, 1000]);
const $cb2cd = $made(Entry, $cc442, ["slip", $cb559, true, "", "slip = [\"0 mm\", \"2 mm\", \"10 mm\"]", "slip", ""]);
const $c9a39 = $made(Entry, $cc442, ["pressure", $c39ba, true, "", "", "pressure", ""]);
const $c1440 = $made(Limit, $cf70d, ["number", 0.0, 5.0, false, false]);
const $c819c = $made(Quantity, $cd20a, ["number", $c1440]);
const $cbcda = $made(Rows, $ce552, [$c819c, 2, 1000]);
const $cae06 = $made(Entry, $cc442, ["friction", $cbcda, true, "", "", "values", ""]);
const $ca57a = [$c9a39, $cae06];
const $c6913 = new Map([["pressure", $c9a39], ["friction", $cae06]]);
const $cc58e = $made(tables$Table, $c38db, [null, null, $ca57a, $c6913]);
const $cf471 = $made(Rows, $ce552, [$cc58e, 1, 200]);
const $c63ba = $made(Entry, $cc442, ["rows", $cf471, true, "", "rows = [{ pressure = \"100 kPa\", friction = [0.0, 0.4, 0.5] }], a friction for each slip", "rows", ""]);
const $c64e9 = [$ce458, $cb8a8, $cd10e, $ce384, $cca84, $c1057, $caa9e, $cb813, $c0aa1, $cfb99, $cb2cd, $c63ba];
const $c1a55 = new Map([["kind", $ce458], ["condition", $cb8a8], ["provenance", $cd10e], ["condition_factor", $ce384], ["condition_source", $cca84], ["fit", $c1057], ["slip_includes", $caa9e], ["slip_speed_factor", $cb813], ["temperature_factor", $c0aa1], ["notes", $cfb99], ["slip", $cb2cd], ["rows", $c63ba]]);
const $c4e17 = $made(tables$Table, $c38db, [MeasuredTable, null, $c64e9, $c1a55]);
const $c6696 = new Map([["integral-log", $c5f9b], ["constant", $cacce], ["elastic-plastic", $c13aa], ["power", $ce558], ["table", $c4e17]]);
const $c4eae = $made(Variant, $c3ebe, ["kind", $c6696]);
const $c2815 = $made(OneOrMore, $cf6b7, [$c4eae, 50]);
const $c8818 = $made(Entry, $cc442, ["law", $c2815, false, "", "", "law", ""]);
const $c153b = $made(Limit, $cf70d, ["number", 0.0, 1.0, false, false]);
const $c6b9b = $made(Percent, $c7fcc, ["number", $c153b, 1.0]);
const $c2685 = $made(ByName, $cf6b7, [$c6b9b, 200]);
const $c5c71 = $made(Entry, $cc442, ["uncertainty", $c2685, false, "", "", "uncertainty", ""]);
const $c0a9d = $made(Entry, $cc442, ["notes", $cf44f, false, "", "", "notes", ""]);
const $c82fd = [$cfab4, $c7e8f, $cd66f, $cc3a1, $c5462, $ca06f, $c99bb, $c3ae4, $c3f7b, $c29e5, $c2d43, $c3692, $c1d96, $c9f8f, $c03097, $c2480, $c2fb3, $c7315, $c8818, $c5c71, $c69c3, $c9b00, $c0a9d];
const $c854f = new Map([["preset", $cfab4], ["name", $c7e8f], ["title", $cd66f], ["description", $cc3a1], ["surface", $c5462], ["thickness", $ca06f], ["elastic_modulus", $c99bb], ["shear_modulus", $c3ae4], ["compression_modulus", $c3f7b], ["block", $c29e5], ["wear_coefficient", $c2d43], ["belt_energy_share", $c3692], ["bond_strength", $c1d96], ["fatigue_limit", $c9f8f], ["cost", $c03097], ["slip_speed", $c2480], ["temperature", $c2fb3], ["condition_factor", $c7315], ["law", $c8818], ["uncertainty", $c5c71], ["provenance", $c69c3], ["sources", $c9b00], ["notes", $c0a9d]]);
const $c74dd = $made(tables$Table, $c38db, [Lagging, null, $c82fd, $c854f]);
const $c213c = $made(TextOr, $cea31, [$c0ecb, $c74dd]);
const $c29a1 = $made(Entry, $cc442, ["lagging", $c213c, true, "", "lagging = \"diamond-rubber\"", "lagging", ""]);
const $c4ee1 = $made(Entry, $cc442, ["condition", $c6e45, false, "", "", "condition", ""]);
const $cb6cf = $made(Limit, $cf70d, ["force", 0.1, 1000000000.0, false, false]);
const $c0765 = $made(Quantity, $cd20a, ["force", $cb6cf]);
const $c65de = $made(Entry, $cc442, ["entry_tension", $c0765, false, "", "", "entry_tension", ""]);
const $c5335 = $made(Entry, $cc442, ["exit_tension", $c0765, false, "", "", "exit_tension", ""]);
const $c649b = $made(Quantity, $cd20a, ["force", null]);
const $c66ac = $made(Entry, $cc442, ["effective_tension", $c649b, false, "", "", "effective_tension", ""]);
const $c60ad7 = $made(Quantity, $cd20a, ["torque", null]);
const $c6209 = $made(Entry, $cc442, ["torque", $c60ad7, false, "", "", "torque", ""]);
const $cf058 = $made(Quantity, $cd20a, ["power", null]);
const $c012a = $made(Entry, $cc442, ["power", $cf058, false, "", "", "power", ""]);
const $cd18d = $made(Limit, $cf70d, ["length", -1.0, 1.0, false, false]);
const $c4158 = $made(Quantity, $cd20a, ["length", $cd18d]);
const $c7b22 = $made(WordOr, $c6a10, ["formula", $c4158, null]);
const $c2929 = $made(Entry, $cc442, ["overrun", $c7b22, false, "", "", "overrun", ""]);
const $c35bd = $made(Flag, [], []);
const $cd03d = $made(Entry, $cc442, ["recovery", $c35bd, false, "", "", "recovery", ""]);
const $c51e2 = $made(Quantity, $cd20a, ["length", $c2680]);
const $c2278 = $made(Entry, $cc442, ["creep_limit", $c51e2, false, "", "", "creep_limit", ""]);
const $ca867 = ["pulley", "carry"];
const $c174d = new Map([]);
const $cbced = $made(Choice, $c322f, [$ca867, $c174d]);
const $ce358 = $made(Entry, $cc442, ["side", $cbced, false, "", "", "side", ""]);
const $c7194 = $made(Limit, $cf70d, ["mass", 0.0, 1000000.0, true, false]);
const $c66cf = $made(Quantity, $cd20a, ["mass", $c7194]);
const $cb6e8 = $made(Entry, $cc442, ["mass", $c66cf, false, "", "", "mass", ""]);
const $c6a45 = ["dimension", "diameters", "rows", "within"];
const $cf6b1 = ["kinds"];
const $ce931 = $made(Quantity, $cd20a, ["length", null]);
const $c772b = $made(Quantity, $cd20a, ["length", null]);
const $cc4bd = [$ce931, $c772b];
const $ce3dd = $made(_Pair, $cf6b1, [$cc4bd]);
const $c5e17 = $made(Rows, $ce552, [$ce3dd, 0, 500]);
const $cb6ae = $made(Entry, $cc442, ["rows", $c5e17, false, "", "", "rows", ""]);
const $ca825 = $made(Quantity, $cd20a, ["length", null]);
const $ce7bc = $made(Entry, $cc442, ["crown", $ca825, false, "", "", "crown", ""]);
const $c9d79 = $made(Limit, $cf70d, ["number", 0.0, 100.0, false, false]);
const $c9db6 = $made(Quantity, $cd20a, ["number", $c9d79]);
const $ca868 = $made(Entry, $cc442, ["factor", $c9db6, false, "", "", "factor", ""]);
const $cd362 = $made(Limit, $cf70d, ["length", 0.0, Infinity, false, false]);
const $cc52b = $made(Quantity, $cd20a, ["length", $cd362]);
const $c3c8f = $made(Entry, $cc442, ["uncertainty", $cc52b, false, "", "", "uncertainty", ""]);
const $c79e1 = ["radius", "diameter"];
const $cb0f1 = new Map([]);
const $c36d5 = $made(Choice, $c322f, [$c79e1, $cb0f1]);
const $c043c = $made(Entry, $cc442, ["on", $c36d5, false, "", "", "on", ""]);
const $c575e = [$cb6ae, $ce7bc, $ca868, $c3c8f, $c043c];
const $cd5be = new Map([["rows", $cb6ae], ["crown", $ce7bc], ["factor", $ca868], ["uncertainty", $c3c8f], ["on", $c043c]]);
const $c1a37 = $made(tables$Table, $c38db, [null, null, $c575e, $cd5be]);
const $c670b = $made(TextOr, $cea31, [$c5e17, $c1a37]);
const $c7d98 = $made(Profile, $c6a45, ["length", true, $c5e17, $c670b]);
const $c4834 = $made(Entry, $cc442, ["shell_profile", $c7d98, false, "", "", "shell_profile", ""]);
const $c6efc = $made(Quantity, $cd20a, ["length", null]);
const $ca463 = $made(Quantity, $cd20a, ["length", null]);
const $c7fa6 = [$c6efc, $ca463];
const $cc4de = $made(_Pair, $cf6b1, [$c7fa6]);
const $c0746 = $made(Rows, $ce552, [$cc4de, 0, 500]);
const $cdfa3 = $made(Entry, $cc442, ["rows", $c0746, false, "", "", "rows", ""]);
const $c1b8c = $made(Quantity, $cd20a, ["length", null]);
const $ca6dd = $made(Entry, $cc442, ["crown", $c1b8c, false, "", "", "crown", ""]);
const $c0816 = $made(Limit, $cf70d, ["number", 0.0, 100.0, false, false]);
const $c4df7 = $made(Quantity, $cd20a, ["number", $c0816]);
const $c0749 = $made(Entry, $cc442, ["factor", $c4df7, false, "", "", "factor", ""]);
const $c3e3d = $made(Limit, $cf70d, ["length", 0.0, Infinity, false, false]);
const $c7af9 = $made(Quantity, $cd20a, ["length", $c3e3d]);
const $c52ae = $made(Entry, $cc442, ["uncertainty", $c7af9, false, "", "", "uncertainty", ""]);
const $c29ffa = new Map([]);
const $c7e9f = $made(Choice, $c322f, [$c79e1, $c29ffa]);
const $cce85 = $made(Entry, $cc442, ["on", $c7e9f, false, "", "", "on", ""]);
const $c1516 = [$cdfa3, $ca6dd, $c0749, $c52ae, $cce85];
const $c5d84 = new Map([["rows", $cdfa3], ["crown", $ca6dd], ["factor", $c0749], ["uncertainty", $c52ae], ["on", $cce85]]);
const $cc9ad = $made(tables$Table, $c38db, [null, null, $c1516, $c5d84]);
const $c7ff2 = $made(TextOr, $cea31, [$c0746, $cc9ad]);
const $c57d1 = $made(Profile, $c6a45, ["length", true, $c0746, $c7ff2]);
const $cb05f = $made(Entry, $cc442, ["worn_depth", $c57d1, false, "", "", "worn_depth", ""]);
const $c3154 = $made(Quantity, $cd20a, ["length", null]);
const $c25f6 = $made(Quantity, $cd20a, ["length", null]);
const $cacef = [$c3154, $c25f6];
const $c0ec0 = $made(_Pair, $cf6b1, [$cacef]);
const $cd0f7 = $made(Rows, $ce552, [$c0ec0, 0, 500]);
const $cfc97 = $made(Entry, $cc442, ["rows", $cd0f7, false, "", "", "rows", ""]);
const $c175f = $made(Quantity, $cd20a, ["length", null]);
const $c21c2 = $made(Entry, $cc442, ["crown", $c175f, false, "", "", "crown", ""]);
const $cea3c = $made(Limit, $cf70d, ["number", 0.0, 100.0, false, false]);
const $cf93e = $made(Quantity, $cd20a, ["number", $cea3c]);
const $c8e0b = $made(Entry, $cc442, ["factor", $cf93e, false, "", "", "factor", ""]);
const $c6219 = $made(Limit, $cf70d, ["length", 0.0, Infinity, false, false]);
const $c3b46 = $made(Quantity, $cd20a, ["length", $c6219]);
const $c7ba1 = $made(Entry, $cc442, ["uncertainty", $c3b46, false, "", "", "uncertainty", ""]);
const $c42ac = new Map([]);
const $ca143 = $made(Choice, $c322f, [$c79e1, $c42ac]);
const $c438a = $made(Entry, $cc442, ["on", $ca143, false, "", "", "on", ""]);
const $c4ced = [$cfc97, $c21c2, $c8e0b, $c7ba1, $c438a];
const $c80c4 = new Map([["rows", $cfc97], ["crown", $c21c2], ["factor", $c8e0b], ["uncertainty", $c7ba1], ["on", $c438a]]);
const $cadee = $made(tables$Table, $c38db, [null, null, $c4ced, $c80c4]);
const $ca6a5 = $made(TextOr, $cea31, [$cd0f7, $cadee]);
const $ce754 = $made(Profile, $c6a45, ["length", true, $cd0f7, $ca6a5]);
const $ca521 = $made(Entry, $cc442, ["build_up", $ce754, false, "", "", "build_up", ""]);
const $cbde1 = $made(Limit, $cf70d, ["number", -0.1, 0.1, false, false]);
const $c9055 = $made(Quantity, $cd20a, ["number", $cbde1]);
const $ca5e0 = $made(Entry, $cc442, ["misalignment", $c9055, false, "", "", "misalignment", ""]);
const $c94dd = $made(Limit, $cf70d, ["length", -0.1, 0.1, false, false]);
const $c162e = $made(Quantity, $cd20a, ["length", $c94dd]);
const $c2af9 = $made(Entry, $cc442, ["deflection", $c162e, false, "", "", "deflection", ""]);
const $ce004 = $made(Quantity, $cd20a, ["length", null]);
const $c9718 = $made(Quantity, $cd20a, ["force_per_width", null]);
const $cad01 = [$ce004, $c9718];
const $cdfd7 = $made(_Pair, $cf6b1, [$cad01]);
const $c0408 = $made(Rows, $ce552, [$cdfd7, 0, 500]);
const $c9e25 = $made(Entry, $cc442, ["rows", $c0408, false, "", "", "rows", ""]);
const $c728a = $made(Quantity, $cd20a, ["force_per_width", null]);
const $cb2e0 = $made(Entry, $cc442, ["crown", $c728a, false, "", "", "crown", ""]);
const $c71d8 = $made(Limit, $cf70d, ["number", 0.0, 100.0, false, false]);
const $c31bc = $made(Quantity, $cd20a, ["number", $c71d8]);
const $c6847 = $made(Entry, $cc442, ["factor", $c31bc, false, "", "", "factor", ""]);
const $c4297 = $made(Limit, $cf70d, ["force_per_width", 0.0, Infinity, false, false]);
const $cbbb6 = $made(Quantity, $cd20a, ["force_per_width", $c4297]);
const $ced4a = $made(Entry, $cc442, ["uncertainty", $cbbb6, false, "", "", "uncertainty", ""]);
const $cc96a = [$c9e25, $cb2e0, $c6847, $ced4a];
const $c8e0bb = new Map([["rows", $c9e25], ["crown", $cb2e0], ["factor", $c6847], ["uncertainty", $ced4a]]);
const $cf68a = $made(tables$Table, $c38db, [null, null, $cc96a, $c8e0bb]);
const $c1009 = $made(TextOr, $cea31, [$c0408, $cf68a]);
const $c188d = $made(Profile, $c6a45, ["force_per_width", false, $c0408, $c1009]);
const $c4f67 = $made(Entry, $cc442, ["entry_profile", $c188d, false, "", "", "entry_profile", ""]);
const $ccca6 = ["pulley"];
const $c55ac = new Map([]);
const $c3bba = $made(Choice, $c322f, [$ccca6, $c55ac]);
const $cdfdd = $made(Entry, $cc442, ["kind", $c3bba, true, "", "", "kind", ""]);
const $c29d2 = $made(Limit, $cf70d, ["length", 0.0, 100000.0, true, false]);
const $cae66 = $made(Quantity, $cd20a, ["length", $c29d2]);
const $c500d = $made(Entry, $cc442, ["distance", $cae66, true, "", "", "distance", ""]);
const $c2f6d = [$cdfdd, $c500d];
const $cf93c = new Map([["kind", $cdfdd], ["distance", $c500d]]);
const $c5714 = $made(tables$Table, $c38db, [GrippingPulley, null, $c2f6d, $cf93c]);
const $cff7c = ["transition"];
const $c51af = new Map([]);
const $cc88c = $made(Choice, $c322f, [$cff7c, $c51af]);
const $c62db = $made(Entry, $cc442, ["kind", $cc88c, true, "", "", "kind", ""]);
const $c96f8 = $made(Limit, $cf70d, ["length", 0.0, 1000.0, true, false]);
const $c102e = $made(Quantity, $cd20a, ["length", $c96f8]);
const $cbb25 = $made(Entry, $cc442, ["length", $c102e, true, "", "length = \"2.9 m\"", "length", ""]);
const $cd50c = $made(Limit, $cf70d, ["angle", 0.0, 1.5707963267948966, true, false]);
const $c6442 = $made(Quantity, $cd20a, ["angle", $cd50c]);
const $c48bf = $made(Entry, $cc442, ["trough_angle", $c6442, true, "", "trough_angle = \"35 deg\"", "trough_angle", ""]);
const $c3fe0 = $made(Limit, $cf70d, ["length", 0.0, 100.0, false, false]);
const $c97a4 = $made(Quantity, $cd20a, ["length", $c3fe0]);
const $ce362 = $made(Entry, $cc442, ["centre_roll", $c97a4, true, "", "centre_roll = \"465 mm\"", "centre_roll", ""]);
const $c8b63 = ["full", "half"];
const $ca9ff = new Map([]);
const $c0db5 = $made(Choice, $c322f, [$c8b63, $ca9ff]);
const $c2eb3 = $made(Entry, $cc442, ["depth", $c0db5, false, "", "", "depth", ""]);
const $c6143 = [$c62db, $cbb25, $c48bf, $ce362, $c2eb3];
const $c7886 = new Map([["kind", $c62db], ["length", $cbb25], ["trough_angle", $c48bf], ["centre_roll", $ce362], ["depth", $c2eb3]]);
const $c81e5 = $made(tables$Table, $c38db, [Transition, null, $c6143, $c7886]);
const $c7fda = new Map([["pulley", $c5714], ["transition", $c81e5]]);
const $c5ba2 = $made(Variant, $c3ebe, ["kind", $c7fda]);
const $c0177 = $made(WordOr, $c6a10, ["far", $c5ba2, null]);
const $c62d1 = $made(Entry, $cc442, ["before", $c0177, false, "", "", "before", ""]);
const $c4c897 = ["pulley"];
const $c4659 = new Map([]);
const $c8b57 = $made(Choice, $c322f, [$c4c897, $c4659]);
const $cb41f = $made(Entry, $cc442, ["kind", $c8b57, true, "", "", "kind", ""]);
const $c460e = [$cb41f, $c500d];
const $c0cc5 = new Map([["kind", $cb41f], ["distance", $c500d]]);
const $c7e5c = $made(tables$Table, $c38db, [GrippingPulley, null, $c460e, $c0cc5]);
const $caabd = new Map([["pulley", $c7e5c]]);
const $c5263 = $made(Variant, $c3ebe, ["kind", $caabd]);
const $c6fb1 = $made(WordOr, $c6a10, ["far", $c5263, null]);
const $cc60d = $made(Entry, $cc442, ["after", $c6fb1, false, "", "", "after", ""]);
const $c38c6 = ["least", "most"];
const $cec8f = $made(Count, $c38c6, [4, 128]);
const $c1b7e = $made(Entry, $cc442, ["strips", $cec8f, false, "", "", "strips", ""]);
const $cb035 = [$c4834, $cb05f, $ca521, $ca5e0, $c2af9, $c4f67, $c62d1, $cc60d, $c1b7e];
const $c0207 = new Map([["shell_profile", $c4834], ["worn_depth", $cb05f], ["build_up", $ca521], ["misalignment", $ca5e0], ["deflection", $c2af9], ["entry_profile", $c4f67], ["before", $c62d1], ["after", $cc60d], ["strips", $c1b7e]]);
const $c7a37 = $made(tables$Table, $c38db, [Across, null, $cb035, $c0207]);
const $c152a = $made(Entry, $cc442, ["across", $c7a37, false, "", "", "across", ""]);
const $ce50a = $made(Limit, $cf70d, ["number", 0.0, 1.0, false, false]);
const $c4ff0 = $made(Percent, $c7fcc, ["number", $ce50a, 1.0]);
const $c5f05 = $made(ByName, $cf6b7, [$c4ff0, 200]);
const $ccdce = $made(Entry, $cc442, ["uncertainty", $c5f05, false, "", "", "uncertainty", ""]);
const $ce5d6 = $made(ByName, $cf6b7, [$cc542, 200]);
const $c480f = $made(Entry, $cc442, ["sources", $ce5d6, false, "", "", "sources", ""]);
const $c06ce = [$c0948, $c75c1, $ce003, $c65eb, $c29a1, $c4ee1, $c65de, $c5335, $c66ac, $c6209, $c012a, $c2929, $cd03d, $c2278, $ce358, $cb6e8, $c152a, $ccdce, $c480f];
const $c2aac = new Map([["name", $c0948], ["diameter", $c75c1], ["wrap_angle", $ce003], ["belt_path", $c65eb], ["lagging", $c29a1], ["condition", $c4ee1], ["entry_tension", $c65de], ["exit_tension", $c5335], ["effective_tension", $c66ac], ["torque", $c6209], ["power", $c012a], ["overrun", $c2929], ["recovery", $cd03d], ["creep_limit", $c2278], ["side", $ce358], ["mass", $cb6e8], ["across", $c152a], ["uncertainty", $ccdce], ["sources", $c480f]]);
const $c706c = $made(tables$Table, $c38db, [Pulley, null, $c06ce, $c2aac]);
const $cb00b = $made(Rows, $ce552, [$c706c, 1, 10]);
const $c2dd7 = $made(Entry, $cc442, ["pulley", $cb00b, true, "", "a [[pulley]] table for each pulley", "pulley", ""]);
const $cffc2 = $made(ByName, $cf6b7, [$c74dd, 200]);
const $c141c = $made(Entry, $cc442, ["lagging", $cffc2, false, "", "", "lagging", ""]);
const $c51b7 = ["entry_tension", "exit_tension", "effective_tension", "torque", "power"];
const $ca636 = new Misplaced($c51b7, "tensions of a load case belong to its pulleys", "Write pulley.NAME.{key} in the load case.", "pulley");
const $cb134 = $made(Name, $c4a10, [60]);
const $ceb06 = $made(Entry, $cc442, ["name", $cb134, true, "", "name = \"start\"", "name", ""]);
const $c5d1d = $made(Text, $ceae0, [1000, true]);
const $c14dd = $made(Entry, $cc442, ["description", $c5d1d, false, "", "", "description", ""]);
const $c93f5 = ["running", "starting", "braking"];
const $c87d8 = new Map([["stopping", "braking"]]);
const $cd051 = $made(Choice, $c322f, [$c93f5, $c87d8]);
const $c8d03 = $made(Entry, $cc442, ["kind", $cd051, false, "", "", "kind", ""]);
const $cd64e = $made(Entry, $cc442, ["condition", $c6e45, false, "", "", "condition", ""]);
const $ce811 = $made(Limit, $cf70d, ["number", 0.0, 1.0, false, false]);
const $cb68f = $made(Percent, $c7fcc, ["number", $ce811, 1.0]);
const $c7d78 = $made(ByName, $cf6b7, [$cb68f, 200]);
const $cfa13 = $made(Entry, $cc442, ["uncertainty", $c7d78, false, "", "", "uncertainty", ""]);
const $c3230 = [$c65de, $c5335, $c66ac, $c6209, $c012a, $cfa13];
const $c3c73 = new Map([["entry_tension", $c65de], ["exit_tension", $c5335], ["effective_tension", $c66ac], ["torque", $c6209], ["power", $c012a], ["uncertainty", $cfa13]]);
const $c6810 = $made(tables$Table, $c38db, [null, null, $c3230, $c3c73]);
const $c732c = $made(ByName, $cf6b7, [$c6810, 200]);
const $c7998 = $made(Entry, $cc442, ["pulley", $c732c, false, "", "", "pulley", ""]);
const $cad0f = $made(Elsewhere, [], []);
const $c2d88 = $made(Entry, $cc442, ["train", $cad0f, false, "", "", "train", ""]);
const $cd494 = [$ceb06, $c14dd, $c8d03, $cd64e, $c7998, $c2d88];
const $c6166 = new Map([["name", $ceb06], ["description", $c14dd], ["kind", $c8d03], ["condition", $cd64e], ["pulley", $c7998], ["train", $c2d88]]);
const $c19cf = $made(tables$Table, $c38db, [null, $ca636, $cd494, $c6166]);
const $c7e6d = $made(Rows, $ce552, [$c19cf, 1, 1000]);
const $cf53e = $made(Entry, $cc442, ["load_case", $c7e6d, false, "", "", "load_case", ""]);
const $c43da = $made(Limit, $cf70d, ["length", 0.0, 100000.0, true, false]);
const $c92fc = $made(Quantity, $cd20a, ["length", $c43da]);
const $c4d7c = $made(Entry, $cc442, ["length", $c92fc, true, "", "length = \"600 m\"", "length", "flight"]);
const $cb699 = $made(Limit, $cf70d, ["length", -5000.0, 5000.0, false, false]);
const $c6ee6 = $made(Quantity, $cd20a, ["length", $cb699]);
const $c012e = $made(Entry, $cc442, ["lift", $c6ee6, false, "", "", "lift", ""]);
const $cd830 = $made(Limit, $cf70d, ["mass_per_length", 0.0, 10000.0, true, false]);
const $c117d = $made(Quantity, $cd20a, ["mass_per_length", $cd830]);
const $c44a9 = $made(Entry, $cc442, ["belt_mass", $c117d, false, "", "", "belt_mass", ""]);
const $cd2f7 = $made(Limit, $cf70d, ["mass_per_length", 0.0, 10000.0, false, false]);
const $c5673 = $made(Quantity, $cd20a, ["mass_per_length", $cd2f7]);
const $caadb = $made(Entry, $cc442, ["carry_idler_mass", $c5673, true, "", "", "carry_idler_mass", ""]);
const $caf1b = $made(Limit, $cf70d, ["mass_per_length", 0.0, 10000.0, false, false]);
const $c5248 = $made(Quantity, $cd20a, ["mass_per_length", $caf1b]);
const $c5841 = $made(Entry, $cc442, ["return_idler_mass", $c5248, true, "", "", "return_idler_mass", ""]);
const $c4a16 = $made(Quantity, $cd20a, ["mass_per_length", $cd830]);
const $cd1cc = $made(Entry, $cc442, ["material_mass", $c4a16, false, "", "", "material_mass", ""]);
const $c7957 = $made(Limit, $cf70d, ["mass_flow", 0.0, 100000.0, true, false]);
const $c3ec4 = $made(Quantity, $cd20a, ["mass_flow", $c7957]);
const $c8f62 = $made(Entry, $cc442, ["capacity", $c3ec4, false, "", "", "capacity", ""]);
const $c66b2 = $made(Limit, $cf70d, ["number", 0.005, 0.1, false, false]);
const $c71aa = $made(Quantity, $cd20a, ["number", $c66b2]);
const $c8f63 = $made(Entry, $cc442, ["friction_factor", $c71aa, false, "", "", "friction_factor", ""]);
const $c0af8 = $made(Limit, $cf70d, ["number", 1.0, 10.0, false, false]);
const $c9fce = $made(Quantity, $cd20a, ["number", $c0af8]);
const $cd4f6 = $made(Entry, $cc442, ["length_coefficient", $c9fce, false, "", "", "length_coefficient", ""]);
const $c05e0 = $made(Limit, $cf70d, ["force", 0.0, 100000000.0, false, false]);
const $c85d7 = $made(Quantity, $cd20a, ["force", $c05e0]);
const $c6302 = $made(Entry, $cc442, ["secondary_resistance", $c85d7, false, "", "", "secondary_resistance", ""]);
const $c0a2c = $made(Quantity, $cd20a, ["force", $c05e0]);
const $c1d8e = $made(Entry, $cc442, ["special_resistance", $c0a2c, false, "", "", "special_resistance", ""]);
const $caaf2 = $made(Limit, $cf70d, ["number", 0.0, 1.0, false, false]);
const $c498e = $made(Quantity, $cd20a, ["number", $caaf2]);
const $c2d7e = $made(Entry, $cc442, ["return_share", $c498e, false, "", "", "return_share", ""]);
const $c6d8e = $made(Limit, $cf70d, ["number", 1.0, 5.0, false, false]);
const $c6710 = $made(Quantity, $cd20a, ["number", $c6d8e]);
const $cbc42 = $made(Entry, $cc442, ["start_factor", $c6710, false, "", "", "start_factor", ""]);
const $c9c97 = $made(Limit, $cf70d, ["time", 0.0, 3600.0, true, false]);
const $c0fee = $made(Quantity, $cd20a, ["time", $c9c97]);
const $c96e1 = $made(Entry, $cc442, ["start_time", $c0fee, false, "", "", "start_time", ""]);
const $c1474 = $made(Quantity, $cd20a, ["time", $c9c97]);
const $ca937 = $made(Entry, $cc442, ["stop_time", $c1474, false, "", "", "stop_time", ""]);
const $ca33b = $made(Limit, $cf70d, ["force", 0.0, 100000000.0, true, false]);
const $cd5a6 = $made(Quantity, $cd20a, ["force", $ca33b]);
const $c95e5 = $made(Entry, $cc442, ["take_up_tension", $cd5a6, false, "", "", "take_up_tension", ""]);
const $caef3 = $made(Limit, $cf70d, ["mass", 0.0, 10000000.0, true, false]);
const $c83e7 = $made(Quantity, $cd20a, ["mass", $caef3]);
const $c29bc = $made(Entry, $cc442, ["counterweight", $c83e7, false, "", "", "counterweight", ""]);
const $c592c = $made(Limit, $cf70d, ["length", 0.0, 100000.0, false, false]);
const $ca269 = $made(Quantity, $cd20a, ["length", $c592c]);
const $cc043 = $made(Entry, $cc442, ["take_up_distance", $ca269, false, "", "", "take_up_distance", ""]);
const $c6846 = ["head", "tail"];
const $c4e4c = new Map([]);
const $cd972 = $made(Choice, $c322f, [$c6846, $c4e4c]);
const $cd465 = $made(Entry, $cc442, ["drive_at", $cd972, false, "", "", "drive_at", ""]);
const $cc382 = $made(Limit, $cf70d, ["length", 0.0, 100.0, true, false]);
const $c46da = $made(Quantity, $cd20a, ["length", $cc382]);
const $c70af = $made(Entry, $cc442, ["carry_spacing", $c46da, false, "", "", "carry_spacing", ""]);
const $c81f1 = $made(Quantity, $cd20a, ["length", $cc382]);
const $ce949 = $made(Entry, $cc442, ["return_spacing", $c81f1, false, "", "", "return_spacing", ""]);
const $cdf72 = $made(Limit, $cf70d, ["number", 0.0, 0.1, true, false]);
const $caf98 = $made(Quantity, $cd20a, ["number", $cdf72]);
const $c5148 = $made(Entry, $cc442, ["sag_limit", $caf98, false, "", "", "sag_limit", ""]);
const $cd5b3 = $made(Limit, $cf70d, ["number", 0.0, 1.0, false, false]);
const $c8901 = $made(Quantity, $cd20a, ["number", $cd5b3]);
const $c2460 = $made(Entry, $cc442, ["rest_friction", $c8901, false, "", "", "rest_friction", ""]);
const $cdae3 = $made(Name, $c4a10, [60]);
const $cf953 = $made(Entry, $cc442, ["name", $cdae3, true, "", "", "name", ""]);
const $caa2d = $made(Limit, $cf70d, ["length", 0.0, 100000.0, true, false]);
const $c0468 = $made(Quantity, $cd20a, ["length", $caa2d]);
const $cdb64 = $made(Entry, $cc442, ["length", $c0468, true, "", "length = \"600 m\"", "length", ""]);
const $c4521 = $made(Limit, $cf70d, ["length", -5000.0, 5000.0, false, false]);
const $c13ba = $made(Quantity, $cd20a, ["length", $c4521]);
const $c121b = $made(Entry, $cc442, ["lift", $c13ba, false, "", "", "lift", ""]);
const $caf42 = $made(Limit, $cf70d, ["angle", -1.0, 1.0, false, false]);
const $c2d34 = $made(Slope, $cd20a, ["angle", $caf42]);
const $c1f79 = $made(Entry, $cc442, ["slope", $c2d34, false, "", "", "slope", ""]);
const $c60fa = $made(Limit, $cf70d, ["length", 0.0, 1000000.0, true, false]);
const $c526e = $made(Quantity, $cd20a, ["length", $c60fa]);
const $c09ec = $made(Entry, $cc442, ["curve_radius", $c526e, false, "", "", "curve_radius", ""]);
const $c2c94 = $made(Limit, $cf70d, ["number", 0.005, 0.1, false, false]);
const $cb1564 = $made(Quantity, $cd20a, ["number", $c2c94]);
const $c4c26 = $made(Entry, $cc442, ["friction_factor", $cb1564, false, "", "", "friction_factor", ""]);
const $ce405 = $made(Limit, $cf70d, ["mass_per_length", 0.0, 10000.0, false, false]);
const $c5461 = $made(Quantity, $cd20a, ["mass_per_length", $ce405]);
const $cc8b5 = $made(Entry, $cc442, ["carry_idler_mass", $c5461, false, "", "", "carry_idler_mass", ""]);
const $ca04a = $made(Quantity, $cd20a, ["mass_per_length", $ce405]);
const $c3f56 = $made(Entry, $cc442, ["return_idler_mass", $ca04a, false, "", "", "return_idler_mass", ""]);
const $c3412 = $made(Limit, $cf70d, ["length", 0.0, 100.0, true, false]);
const $cdeac = $made(Quantity, $cd20a, ["length", $c3412]);
const $cfed4 = $made(Entry, $cc442, ["carry_spacing", $cdeac, false, "", "", "carry_spacing", ""]);
const $cd47a = $made(Quantity, $cd20a, ["length", $c3412]);
const $c2e03 = $made(Entry, $cc442, ["return_spacing", $cd47a, false, "", "", "return_spacing", ""]);
const $c6266 = [$cf953, $cdb64, $c121b, $c1f79, $c09ec, $c4c26, $cc8b5, $c3f56, $cfed4, $c2e03];
const $cac44 = new Map([["name", $cf953], ["length", $cdb64], ["lift", $c121b], ["slope", $c1f79], ["curve_radius", $c09ec], ["friction_factor", $c4c26], ["carry_idler_mass", $cc8b5], ["return_idler_mass", $c3f56], ["carry_spacing", $cfed4], ["return_spacing", $c2e03]]);
const $c1b6f = $made(tables$Table, $c38db, [Flight, null, $c6266, $cac44]);
const $c2900 = $made(Rows, $ce552, [$c1b6f, 1, 100]);
const $c2aed = $made(Entry, $cc442, ["flight", $c2900, false, "", "", "flights", ""]);
const $cbdf7 = $made(Name, $c4a10, [60]);
const $c7ddb = $made(Entry, $cc442, ["name", $cbdf7, true, "", "", "name", ""]);
const $c92ec = $made(Name, $c4a10, [60]);
const $cca37 = $made(Entry, $cc442, ["flight", $c92ec, false, "", "", "flight", ""]);
const $ccabe = $made(Limit, $cf70d, ["length", 0.0, 100000.0, false, false]);
const $c650b = $made(Quantity, $cd20a, ["length", $ccabe]);
const $cf130 = $made(Entry, $cc442, ["position", $c650b, false, "", "", "position", ""]);
const $c4b8f = $made(Limit, $cf70d, ["mass_flow", 0.0, 100000.0, true, false]);
const $c7b8a = $made(Quantity, $cd20a, ["mass_flow", $c4b8f]);
const $ca245 = $made(Entry, $cc442, ["capacity", $c7b8a, false, "", "", "capacity", ""]);
const $c642a = $made(Limit, $cf70d, ["mass_per_length", 0.0, 10000.0, true, false]);
const $cc70b = $made(Quantity, $cd20a, ["mass_per_length", $c642a]);
const $ce182 = $made(Entry, $cc442, ["material_mass", $cc70b, false, "", "", "material_mass", ""]);
const $ca1af = $made(Limit, $cf70d, ["speed", 0.0, 20.0, false, false]);
const $c2026 = $made(Quantity, $cd20a, ["speed", $ca1af]);
const $c17fe = $made(Entry, $cc442, ["material_speed", $c2026, false, "", "", "material_speed", ""]);
const $c6dc5 = $made(Limit, $cf70d, ["length", 0.0, 10.0, true, false]);
const $cb05fb = $made(Quantity, $cd20a, ["length", $c6dc5]);
const $c9d25 = $made(Entry, $cc442, ["skirt_width", $cb05fb, false, "", "", "skirt_width", ""]);
const $c8497 = $made(Quantity, $cd20a, ["length", $c3412]);
const $c34fd = $made(Entry, $cc442, ["acceleration_length", $c8497, false, "", "", "acceleration_length", ""]);
const $c3f2d = $made(Limit, $cf70d, ["number", 0.0, 2.0, true, false]);
const $cc4e9 = $made(Quantity, $cd20a, ["number", $c3f2d]);
const $ca132 = $made(Entry, $cc442, ["belt_friction", $cc4e9, false, "", "", "belt_friction", ""]);
const $cccce = $made(Quantity, $cd20a, ["number", $c3f2d]);
const $cbcfb = $made(Entry, $cc442, ["skirt_friction", $cccce, false, "", "", "skirt_friction", ""]);
const $c57f6 = $made(Limit, $cf70d, ["density", 0.0, 20000.0, true, false]);
const $c5c20 = $made(Quantity, $cd20a, ["density", $c57f6]);
const $c17d4 = $made(Entry, $cc442, ["density", $c5c20, false, "", "", "density", ""]);
const $cfc60 = [$c7ddb, $cca37, $cf130, $ca245, $ce182, $c17fe, $c9d25, $c34fd, $ca132, $cbcfb, $c17d4];
const $cd4aa = new Map([["name", $c7ddb], ["flight", $cca37], ["position", $cf130], ["capacity", $ca245], ["material_mass", $ce182], ["material_speed", $c17fe], ["skirt_width", $c9d25], ["acceleration_length", $c34fd], ["belt_friction", $ca132], ["skirt_friction", $cbcfb], ["density", $c17d4]]);
const $ce67f = $made(tables$Table, $c38db, [LoadingPoint, null, $cfc60, $cd4aa]);
const $c78a9 = $made(Rows, $ce552, [$ce67f, 1, 20]);
const $cd674 = $made(Entry, $cc442, ["loading", $c78a9, false, "", "", "loadings", ""]);
const $c3267 = $made(Name, $c4a10, [60]);
const $c8b3f = $made(Entry, $cc442, ["name", $c3267, true, "", "", "name", ""]);
const $c13a9 = $made(LoadedFlights, [], []);
const $c63ca = $made(Entry, $cc442, ["loaded", $c13a9, false, "", "", "loaded", ""]);
const $c77f1 = $made(Limit, $cf70d, ["number", 0.0, 10.0, false, false]);
const $cee56 = $made(Quantity, $cd20a, ["number", $c77f1]);
const $c4a3a = $made(ByName, $cf6b7, [$cee56, 200]);
const $cc567 = $made(Entry, $cc442, ["factor", $c4a3a, false, "", "", "factor", ""]);
const $ccbcd = ["running", "starting", "braking"];
const $c34eb = new Map([["stopping", "braking"]]);
const $c4f0e = $made(Choice, $c322f, [$ccbcd, $c34eb]);
const $c9af3 = $made(Entry, $cc442, ["kind", $c4f0e, false, "", "", "kind", ""]);
const $cabe7a = [$c8b3f, $c63ca, $cc567, $c9af3];
const $c7d25 = new Map([["name", $c8b3f], ["loaded", $c63ca], ["factor", $cc567], ["kind", $c9af3]]);
const $c1695 = $made(tables$Table, $c38db, [ConveyorCase, null, $cabe7a, $c7d25]);
const $ce11b = $made(Rows, $ce552, [$c1695, 1, 20]);
const $c1604 = $made(Entry, $cc442, ["load_case", $ce11b, false, "", "", "cases", ""]);
const $c73be = $made(Name, $c4a10, [60]);
const $c0371 = $made(Entry, $cc442, ["pulley", $c73be, true, "", "", "pulley", ""]);
const $ce3f2 = ["head", "tail", "carry", "return"];
const $c0db3 = new Map([]);
const $c6b4b = $made(Choice, $c322f, [$ce3f2, $c0db3]);
const $c98ff = $made(Entry, $cc442, ["at", $c6b4b, false, "", "", "at", ""]);
const $c37ca = $made(Quantity, $cd20a, ["length", $ccabe]);
const $c5c50 = $made(Entry, $cc442, ["position", $c37ca, false, "", "", "position", ""]);
const $c6ee3 = $made(Limit, $cf70d, ["number", -10.0, 10.0, false, false]);
const $c41cd = $made(Quantity, $cd20a, ["number", $c6ee3]);
const $ccded = $made(Entry, $cc442, ["brake_share", $c41cd, false, "", "", "brake_share", ""]);
const $c191a = [$c0371, $c98ff, $c5c50, $ccded];
const $c3c3f = new Map([["pulley", $c0371], ["at", $c98ff], ["position", $c5c50], ["brake_share", $ccded]]);
const $cc308 = $made(tables$Table, $c38db, [DrivePlace, null, $c191a, $c3c3f]);
const $c9131 = $made(Rows, $ce552, [$cc308, 1, 20]);
const $cb4d0 = $made(Entry, $cc442, ["drive", $c9131, false, "", "", "drives", ""]);
const $c2d74 = ["pulley"];
const $c3d23 = new Map([]);
const $c4a7d = $made(Choice, $c322f, [$c2d74, $c3d23]);
const $cec12 = $made(Entry, $cc442, ["kind", $c4a7d, true, "", "", "kind", ""]);
const $cd0e7 = $made(Limit, $cf70d, ["length", 0.0, 100000.0, false, false]);
const $cee83 = $made(Quantity, $cd20a, ["length", $cd0e7]);
const $c5667 = $made(Entry, $cc442, ["position", $cee83, false, "", "", "position", ""]);
const $c874c = $made(Limit, $cf70d, ["length", 0.0, 10.0, true, false]);
const $c0086 = $made(Quantity, $cd20a, ["length", $c874c]);
const $c694d = $made(Entry, $cc442, ["diameter", $c0086, true, "", "", "diameter", ""]);
const $c444b = $made(Limit, $cf70d, ["length", 0.0, 2.0, false, false]);
const $c91d9 = $made(Quantity, $cd20a, ["length", $c444b]);
const $cdd0d = $made(Entry, $cc442, ["shaft_diameter", $c91d9, false, "", "", "shaft_diameter", ""]);
const $ca8c9 = $made(Limit, $cf70d, ["angle", 0.0, 6.283185307179586, true, false]);
const $c729a = $made(Quantity, $cd20a, ["angle", $ca8c9]);
const $c01ff = $made(Entry, $cc442, ["wrap_angle", $c729a, false, "", "", "wrap_angle", ""]);
const $ce3fa9 = $made(Limit, $cf70d, ["mass", 0.0, 100000.0, false, false]);
const $cf088 = $made(Quantity, $cd20a, ["mass", $ce3fa9]);
const $c07fd = $made(Entry, $cc442, ["mass", $cf088, false, "", "", "mass", ""]);
const $c3f3d = $made(Count, $c38c6, [1, 100]);
const $c2ef4 = $made(Entry, $cc442, ["count", $c3f3d, false, "", "", "count", ""]);
const $c3d55 = [$cec12, $c98ff, $c5667, $c694d, $cdd0d, $c01ff, $c07fd, $c2ef4];
const $cbae3 = new Map([["kind", $cec12], ["at", $c98ff], ["position", $c5667], ["diameter", $c694d], ["shaft_diameter", $cdd0d], ["wrap_angle", $c01ff], ["mass", $c07fd], ["count", $c2ef4]]);
const $c393f = $made(tables$Table, $c38db, [PulleyResistance, null, $c3d55, $cbae3]);
const $ce0ab = ["cleaner"];
const $c8777 = new Map([]);
const $c009c = $made(Choice, $c322f, [$ce0ab, $c8777]);
const $c8b7c = $made(Entry, $cc442, ["kind", $c009c, true, "", "", "kind", ""]);
const $c8e86 = $made(Quantity, $cd20a, ["length", $cd0e7]);
const $c9728 = $made(Entry, $cc442, ["position", $c8e86, false, "", "", "position", ""]);
const $c46eb = $made(Quantity, $cd20a, ["length", $c874c]);
const $c41cc = $made(Entry, $cc442, ["width", $c46eb, true, "", "", "width", ""]);
const $c322b = $made(Quantity, $cd20a, ["length", $c874c]);
const $cb4c3 = $made(Entry, $cc442, ["thickness", $c322b, true, "", "", "thickness", ""]);
const $c9a3e = $made(Limit, $cf70d, ["pressure", 0.0, 1000000.0, true, false]);
const $cfe16 = $made(Quantity, $cd20a, ["pressure", $c9a3e]);
const $c4fc8 = $made(Entry, $cc442, ["pressure", $cfe16, true, "", "", "pressure", ""]);
const $ca38a = $made(Limit, $cf70d, ["number", 0.0, 2.0, true, false]);
const $c476c = $made(Quantity, $cd20a, ["number", $ca38a]);
const $c090e = $made(Entry, $cc442, ["friction", $c476c, false, "", "", "friction", ""]);
const $c2325 = [$c8b7c, $c98ff, $c9728, $c41cc, $cb4c3, $c4fc8, $c090e, $c2ef4];
const $ca13b = new Map([["kind", $c8b7c], ["at", $c98ff], ["position", $c9728], ["width", $c41cc], ["thickness", $cb4c3], ["pressure", $c4fc8], ["friction", $c090e], ["count", $c2ef4]]);
const $cd9ac = $made(tables$Table, $c38db, [CleanerResistance, null, $c2325, $ca13b]);
const $c0d48 = ["skirt"];
const $c4da1 = new Map([]);
const $cfbdd = $made(Choice, $c322f, [$c0d48, $c4da1]);
const $c91aa = $made(Entry, $cc442, ["kind", $cfbdd, true, "", "", "kind", ""]);
const $c8d97 = $made(Quantity, $cd20a, ["length", $cd0e7]);
const $c6c80 = $made(Entry, $cc442, ["position", $c8d97, false, "", "", "position", ""]);
const $cb596 = $made(Limit, $cf70d, ["length", 0.0, 10000.0, true, false]);
const $cfa8d = $made(Quantity, $cd20a, ["length", $cb596]);
const $cd9e8 = $made(Entry, $cc442, ["length", $cfa8d, true, "", "", "length", ""]);
const $c92bc = $made(Quantity, $cd20a, ["length", $c874c]);
const $c08a3 = $made(Entry, $cc442, ["width", $c92bc, true, "", "", "width", ""]);
const $cf674 = $made(Limit, $cf70d, ["density", 0.0, 20000.0, true, false]);
const $c6b44 = $made(Quantity, $cd20a, ["density", $cf674]);
const $cb913 = $made(Entry, $cc442, ["density", $c6b44, true, "", "", "density", ""]);
const $c8a42 = $made(Quantity, $cd20a, ["number", $ca38a]);
const $c6b9d = $made(Entry, $cc442, ["friction", $c8a42, false, "", "", "friction", ""]);
const $c78af = [$c91aa, $c6c80, $cd9e8, $c08a3, $cb913, $c6b9d];
const $c94b1 = new Map([["kind", $c91aa], ["position", $c6c80], ["length", $cd9e8], ["width", $c08a3], ["density", $cb913], ["friction", $c6b9d]]);
const $cead1 = $made(tables$Table, $c38db, [SkirtResistance, null, $c78af, $c94b1]);
const $cb0a6 = ["tilt"];
const $cd526 = new Map([]);
const $c3848 = $made(Choice, $c322f, [$cb0a6, $cd526]);
const $c4326 = $made(Entry, $cc442, ["kind", $c3848, true, "", "", "kind", ""]);
const $cbe74 = ["carry", "return"];
const $c55d9 = new Map([]);
const $c0895 = $made(Choice, $c322f, [$cbe74, $c55d9]);
const $ceba2 = $made(Entry, $cc442, ["strand", $c0895, false, "", "", "strand", ""]);
const $c4a8c = $made(Limit, $cf70d, ["angle", 0.0, 0.2, true, false]);
const $cd894 = $made(Quantity, $cd20a, ["angle", $c4a8c]);
const $c2ee1 = $made(Entry, $cc442, ["angle", $cd894, true, "", "angle = \"1.5 deg\"", "angle", ""]);
const $c18d0 = $made(Limit, $cf70d, ["number", 0.0, 1.0, true, false]);
const $c42b2 = $made(Quantity, $cd20a, ["number", $c18d0]);
const $cbc51 = $made(Entry, $cc442, ["trough_coefficient", $c42b2, false, "", "", "trough_coefficient", ""]);
const $c04a0 = $made(Quantity, $cd20a, ["number", $ca38a]);
const $c7a52 = $made(Entry, $cc442, ["friction", $c04a0, false, "", "", "friction", ""]);
const $cd945 = $made(Limit, $cf70d, ["length", 0.0, 100000.0, true, false]);
const $c988e = $made(Quantity, $cd20a, ["length", $cd945]);
const $c01d2 = $made(Entry, $cc442, ["length", $c988e, false, "", "", "length", ""]);
const $c150a = [$c4326, $ceba2, $c2ee1, $cbc51, $c7a52, $c01d2];
const $c100e = new Map([["kind", $c4326], ["strand", $ceba2], ["angle", $c2ee1], ["trough_coefficient", $cbc51], ["friction", $c7a52], ["length", $c01d2]]);
const $c4dea = $made(tables$Table, $c38db, [TiltResistance, null, $c150a, $c100e]);
const $c3ff0 = ["force"];
const $c31b5 = new Map([]);
const $cea7d = $made(Choice, $c322f, [$c3ff0, $c31b5]);
const $c3e57 = $made(Entry, $cc442, ["kind", $cea7d, true, "", "", "kind", ""]);
const $c496f = $made(Quantity, $cd20a, ["length", $cd0e7]);
const $cd804 = $made(Entry, $cc442, ["position", $c496f, false, "", "", "position", ""]);
const $cd303 = $made(Limit, $cf70d, ["force", 0.0, 100000000.0, true, false]);
const $c5c43 = $made(Quantity, $cd20a, ["force", $cd303]);
const $cd736 = $made(Entry, $cc442, ["force", $c5c43, true, "", "", "force", ""]);
const $c6dba = [$c3e57, $c98ff, $cd804, $cd736];
const $cf890 = new Map([["kind", $c3e57], ["at", $c98ff], ["position", $cd804], ["force", $cd736]]);
const $c85cd = $made(tables$Table, $c38db, [PointResistance, null, $c6dba, $cf890]);
const $c7920 = new Map([["pulley", $c393f], ["cleaner", $cd9ac], ["skirt", $cead1], ["tilt", $c4dea], ["force", $c85cd]]);
const $c40f1 = $made(Variant, $c3ebe, ["kind", $c7920]);
const $c1aa2 = $made(Rows, $ce552, [$c40f1, 1, 100]);
const $ca3ee = $made(Entry, $cc442, ["resistance", $c1aa2, false, "", "", "locals", ""]);
const $c2cb0 = $made(Limit, $cf70d, ["number", 0.0, 200.0, false, false]);
const $cc30c = $made(Quantity, $cd20a, ["number", $c2cb0]);
const $cb70f = $made(Entry, $cc442, ["temperature_range", $cc30c, false, "", "", "temperature_range", ""]);
const $c4064 = $made(Limit, $cf70d, ["number", 0.0, 0.001, false, false]);
const $cf8a2 = $made(Quantity, $cd20a, ["number", $c4064]);
const $ca048 = $made(Entry, $cc442, ["thermal_expansion", $cf8a2, false, "", "", "thermal_expansion", ""]);
const $c56d0 = $made(Limit, $cf70d, ["number", 0.0, 0.1, false, false]);
const $c34da = $made(Quantity, $cd20a, ["number", $c56d0]);
const $c6fc3 = $made(Entry, $cc442, ["permanent_elongation", $c34da, false, "", "", "permanent_elongation", ""]);
const $c5ca8 = $made(Limit, $cf70d, ["length", 0.0, 1000.0, false, false]);
const $ca239 = $made(Quantity, $cd20a, ["length", $c5ca8]);
const $cf992 = $made(Entry, $cc442, ["splice_length", $ca239, false, "", "", "splice_length", ""]);
const $c7ff4 = [$cb70f, $ca048, $c6fc3, $cf992];
const $cc6e4 = new Map([["temperature_range", $cb70f], ["thermal_expansion", $ca048], ["permanent_elongation", $c6fc3], ["splice_length", $cf992]]);
const $c9244 = $made(tables$Table, $c38db, [Travel, null, $c7ff4, $cc6e4]);
const $c11fb = $made(Entry, $cc442, ["travel", $c9244, false, "", "", "travel", ""]);
const $c229c = $made(Limit, $cf70d, ["force", 0.0, 1000.0, true, false]);
const $c09bc = $made(Quantity, $cd20a, ["force", $c229c]);
const $c6f26 = $made(Entry, $cc442, ["idler_friction", $c09bc, true, "", "idler_friction = \"1.5 lbf\"", "idler_friction", ""]);
const $c0173 = $made(Limit, $cf70d, ["number", 1.0, 4.0, false, false]);
const $c7dbb = $made(Quantity, $cd20a, ["number", $c0173]);
const $ce0d2 = $made(Entry, $cc442, ["temperature_factor", $c7dbb, false, "", "", "temperature_factor", ""]);
const $c2c05 = $made(Limit, $cf70d, ["number", 0.0, 0.1, true, false]);
const $c26b1 = $made(Quantity, $cd20a, ["number", $c2c05]);
const $c5cc3 = $made(Entry, $cc442, ["ky", $c26b1, true, "", "ky = 0.02", "ky", ""]);
const $c734c = $made(Limit, $cf70d, ["force", 0.0, 100000000.0, false, false]);
const $c4cbc = $made(Quantity, $cd20a, ["force", $c734c]);
const $cce1b = $made(Entry, $cc442, ["other", $c4cbc, false, "", "", "other", ""]);
const $c90f3 = [$c6f26, $ce0d2, $c5cc3, $cce1b];
const $c1dcf = new Map([["idler_friction", $c6f26], ["temperature_factor", $ce0d2], ["ky", $c5cc3], ["other", $cce1b]]);
const $cf8a9 = $made(tables$Table, $c38db, [Cema, null, $c90f3, $c1dcf]);
const $c4e49 = $made(Entry, $cc442, ["cema", $cf8a9, false, "", "", "cema", ""]);
const $c54a6 = $made(Limit, $cf70d, ["number", 0.0, 1.0, false, false]);
const $c44a8 = $made(Percent, $c7fcc, ["number", $c54a6, 1.0]);
const $ca254 = $made(ByName, $cf6b7, [$c44a8, 200]);
const $cec6e = $made(Entry, $cc442, ["uncertainty", $ca254, false, "", "", "uncertainty", ""]);
const $cd25f = [$c4d7c, $c012e, $c44a9, $caadb, $c5841, $cd1cc, $c8f62, $c8f63, $cd4f6, $c6302, $c1d8e, $c2d7e, $cbc42, $c96e1, $ca937, $c95e5, $c29bc, $cc043, $cd465, $c70af, $ce949, $c5148, $c2460, $c2aed, $cd674, $c1604, $cb4d0, $ca3ee, $c11fb, $c4e49, $cec6e];
const $c7438 = new Map([["length", $c4d7c], ["lift", $c012e], ["belt_mass", $c44a9], ["carry_idler_mass", $caadb], ["return_idler_mass", $c5841], ["material_mass", $cd1cc], ["capacity", $c8f62], ["friction_factor", $c8f63], ["length_coefficient", $cd4f6], ["secondary_resistance", $c6302], ["special_resistance", $c1d8e], ["return_share", $c2d7e], ["start_factor", $cbc42], ["start_time", $c96e1], ["stop_time", $ca937], ["take_up_tension", $c95e5], ["counterweight", $c29bc], ["take_up_distance", $cc043], ["drive_at", $cd465], ["carry_spacing", $c70af], ["return_spacing", $ce949], ["sag_limit", $c5148], ["rest_friction", $c2460], ["flight", $c2aed], ["loading", $cd674], ["load_case", $c1604], ["drive", $cb4d0], ["resistance", $ca3ee], ["travel", $c11fb], ["cema", $c4e49], ["uncertainty", $cec6e]]);
const $ca5a9 = $made(tables$Table, $c38db, [Conveyor, null, $cd25f, $c7438]);
const $c8364 = $made(Entry, $cc442, ["conveyor", $ca5a9, false, "", "", "conveyor", ""]);
const $c9cf4 = ["gravity", "winch", "fixed"];
const $ce058 = new Map([]);
const $c0ee3 = $made(Choice, $c322f, [$c9cf4, $ce058]);
const $cbe79 = $made(Entry, $cc442, ["kind", $c0ee3, false, "", "", "kind", ""]);
const $cf433 = $made(Limit, $cf70d, ["number", 0.01, 100.0, false, false]);
const $c9556 = $made(Quantity, $cd20a, ["number", $cf433]);
const $c42f5 = $made(Entry, $cc442, ["sheave_ratio", $c9556, false, "", "", "sheave_ratio", ""]);
const $c738f = $made(Name, $c4a10, [60]);
const $c6aa5 = $made(Entry, $cc442, ["after", $c738f, false, "", "", "after", ""]);
const $c72ee = [$cbe79, $c42f5, $c6aa5];
const $c5fb0 = new Map([["kind", $cbe79], ["sheave_ratio", $c42f5], ["after", $c6aa5]]);
const $c5ee3 = $made(tables$Table, $c38db, [TakeUp, null, $c72ee, $c5fb0]);
const $cdc1c = $made(Entry, $cc442, ["take_up", $c5ee3, false, "", "", "take_up", ""]);
const $c6e6b = ["CEMA", "DIN 22101", "own", "none"];
const $cde9b = new Map([]);
const $caffc = $made(Choice, $c322f, [$c6e6b, $cde9b]);
const $c6984 = $made(Entry, $cc442, ["name", $caffc, false, "", "", "name", ""]);
const $ceb6d = ["dry", "wet", "wet and dirty"];
const $cc1c7 = new Map([]);
const $c8fd9 = $made(Choice, $c322f, [$ceb6d, $cc1c7]);
const $c76d6 = $made(Entry, $cc442, ["condition", $c8fd9, false, "", "", "condition", ""]);
const $c724b = $made(Limit, $cf70d, ["number", 0.01, 2.0, false, false]);
const $c4367 = $made(Quantity, $cd20a, ["number", $c724b]);
const $ce53d = $made(Entry, $cc442, ["friction", $c4367, false, "", "", "friction", ""]);
const $c83ab = $made(Limit, $cf70d, ["number", 1.0, 10.0, false, false]);
const $cefb1 = $made(Quantity, $cd20a, ["number", $c83ab]);
const $c8c78 = $made(Entry, $cc442, ["start_factor", $cefb1, false, "", "", "start_factor", ""]);
const $c227f = $made(Flag, [], []);
const $cd316 = $made(Entry, $cc442, ["binding", $c227f, false, "", "", "binding", ""]);
const $c676e = [$c6984, $c76d6, $ce53d, $c8c78, $cd316];
const $c701e = new Map([["name", $c6984], ["condition", $c76d6], ["friction", $ce53d], ["start_factor", $c8c78], ["binding", $cd316]]);
const $c4fae = $made(tables$Table, $c38db, [DesignStandard, null, $c676e, $c701e]);
const $c25c2 = $made(Entry, $cc442, ["design_standard", $c4fae, false, "", "", "standard", ""]);
const $cfb9b = $made(Quantity, $cd20a, ["number", $c83ab]);
const $c9675 = $made(Entry, $cc442, ["running", $cfb9b, false, "", "", "running", ""]);
const $c0f51 = $made(Quantity, $cd20a, ["number", $c83ab]);
const $c3177 = $made(Entry, $cc442, ["starting", $c0f51, false, "", "", "starting", ""]);
const $c0bfa = $made(Quantity, $cd20a, ["number", $c83ab]);
const $c6f8d = $made(Entry, $cc442, ["braking", $c0bfa, false, "", "", "braking", ""]);
const $c6acf = $made(Text, $ceae0, [500, false]);
const $ce7fd = $made(Entry, $cc442, ["source", $c6acf, false, "", "", "source", ""]);
const $cd086 = [$c9675, $c3177, $c6f8d, $ce7fd];
const $c3ec2 = new Map([["running", $c9675], ["starting", $c3177], ["braking", $c6f8d], ["source", $ce7fd]]);
const $c3715 = $made(tables$Table, $c38db, [SafetyFactors, null, $cd086, $c3ec2]);
const $cdb8f = $made(Entry, $cc442, ["safety_factor", $c3715, false, "", "", "safety", ""]);
const $c8124 = $made(Limit, $cf70d, ["length", 0.0, 100.0, true, false]);
const $cd6ed = $made(Quantity, $cd20a, ["length", $c8124]);
const $c9e56 = $made(Entry, $cc442, ["idler_spacing", $cd6ed, true, "", "idler_spacing = \"3 m\"", "spacing", ""]);
const $ce5b8 = $made(Limit, $cf70d, ["mass_per_length", 0.0, 10000.0, true, false]);
const $c428b = $made(Quantity, $cd20a, ["mass_per_length", $ce5b8]);
const $cd978 = $made(Entry, $cc442, ["line_mass", $c428b, false, "", "", "line_mass", ""]);
const $c38da = $made(Limit, $cf70d, ["number", 0.0, 0.1, true, false]);
const $cf084 = $made(Quantity, $cd20a, ["number", $c38da]);
const $c1941 = $made(Entry, $cc442, ["share", $cf084, false, "", "", "share", ""]);
const $c8410 = [$c9e56, $cd978, $c1941];
const $c5121 = new Map([["idler_spacing", $c9e56], ["line_mass", $cd978], ["share", $c1941]]);
const $c9f3b = $made(tables$Table, $c38db, [Sag, null, $c8410, $c5121]);
const $c490f = $made(Entry, $cc442, ["sag", $c9f3b, false, "", "", "sag", ""]);
const $c72c0 = $made(Flag, [], []);
const $c1441 = $made(Entry, $cc442, ["covered", $c72c0, false, "", "", "covered", ""]);
const $cfb1c = $made(Elsewhere, [], []);
const $cf4d4 = $made(Entry, $cc442, ["train", $cfb1c, false, "", "", "train", ""]);
const $ce9c0 = $made(Elsewhere, [], []);
const $cb32b = $made(Entry, $cc442, ["motion", $ce9c0, false, "", "", "motion", ""]);
const $c17ac = $made(Elsewhere, [], []);
const $c1e1e = $made(Entry, $cc442, ["learned", $c17ac, false, "", "", "learned", ""]);
const $c4e7d = [$cb73a, $c34bd, $ce3f29, $cb10e, $c750b, $cfe86, $c2dd7, $c141c, $cf53e, $c8364, $cdc1c, $c25c2, $cdb8f, $c490f, $c1441, $cf4d4, $cb32b, $c1e1e];
const $c8d19 = new Map([["format", $cb73a], ["title", $c34bd], ["description", $ce3f29], ["creep_limit", $cb10e], ["condition", $c750b], ["belt", $cfe86], ["pulley", $c2dd7], ["lagging", $c141c], ["load_case", $cf53e], ["conveyor", $c8364], ["take_up", $cdc1c], ["design_standard", $c25c2], ["safety_factor", $cdb8f], ["sag", $c490f], ["covered", $c1441], ["train", $cf4d4], ["motion", $cb32b], ["learned", $c1e1e]]);
const $cca53 = $made(tables$Table, $c38db, [Drive, null, $c4e7d, $c8d19]);
const $cc3f6 = ["modulus"];
const $c205c = new Map([["wrap", "wrap_angle"], ["torque", "effective_tension"], ["power", "effective_tension"]]);
const $ca9ba = $made(_Nothing, [], []);
const $c01ee = new Map([[8211, "-"], [215, "x"], [8722, "-"], [160, " "], [8243, "\""], [8221, "\""], [1045, "E"], [1056, "P"], [216, "0"], [42, "x"]]);
const $c25ce = $re("(?:(?:DIN|ISO|EN|AS|IS|GB/T|JIS)\\s*(?:EN\\s*)?[A-Z]?\\s*\\d+\\S*\\s+(?:[A-Z]{1,4}\\s+)?)?(?:B?\\s*\\d{3,4}\\s*(?:MM)?\\s+)?(?<carcass>EP|PN|EE|NN|PP|P)\\s*-?\\s*(?<strength>\\d{2,5})\\s*(?<sign>[-/:X])\\s*(?<plies>\\d+)(?:\\s*PLY|\\s*PLIES)?(?![\\d.,])(?<piw>\\s*PIW\\b)?(?:\\s*[-,]?\\s*(?:(?<carry>\\d+(?:[.,]\\d+)?)\\s*(?:MM)?\\s*[TS]?\\s*[-+/:X]\\s*(?<pulley>\\d+(?:[.,]\\d+)?)\\s*(?:MM)?|(?<top>\\d+/\\d+)\\s*(?:IN\\b|\")?\\s*[-+:X]\\s*(?<bottom>\\d+/\\d+)\\s*(?:IN\\b|\")?))?(?<grade>(?:\\s*[-,]?\\s*[A-Z][A-Z0-9]{0,6}(?:(?:\\s+|\\s*[-,]\\s*)(?:[A-Z][A-Z0-9]{0,6}|\\d{2,5}(?:\\s?MM)?)){0,4})?(?:\\s+B?\\d{3,4}\\s?MM)?)\\s*", "");
const $cade6 = new Map([[79, "0"], [73, "1"], [76, "1"]]);
const $cb164 = $re("[^A-Z0-9]", "");
const $c3cf7 = [160, 200, 250, 315, 400, 500, 630, 800, 1000, 1250, 1600, 2000, 2500, 3150];
const $c84f8 = [80, 100, 125, 150, 160, 200, 250, 300, 315, 350, 400, 450, 500, 600, 630, 800];
const $c65c8 = [500, 630, 800, 1000, 1120, 1250, 1400, 1600, 1800, 2000, 2240, 2250, 2500, 2800, 3150, 3500, 4000, 4500, 5000, 5400, 6000, 6300, 6500, 7000, 7500, 8000, 8500, 9000, 9500, 10000];
const $c4c89 = new DimensionText("m", "a length", "1200 mm");
const $cb7f2 = new DimensionText("N", "a force", "150 kN");
const $ceb3f = new DimensionText("N/m", "a force per width", "12960 kN/m");
const $cb6a4 = new DimensionText("N/m", "a spring rate", "12000 kN/m");
const $c6907 = new DimensionText("Pa", "a pressure", "200 kPa");
const $cabbc = new DimensionText("Pa/m", "a pressure per length", "190 kPa/mm");
const $c12ff = new DimensionText("m/s", "a speed", "3 m/s");
const $ca5a3 = new DimensionText("rad", "an angle", "180 deg");
const $ca327 = new DimensionText("W", "a power", "250 kW");
const $c19d7 = new DimensionText("N m", "a torque", "40 kN m");
const $cc5a9 = new DimensionText("m2", "an area", "2500 mm2");
const $c9e8e = new DimensionText("s", "a time", "10 s");
const $c5e0b = new DimensionText("K", "a temperature", "20 degC");
const $c32f4 = new DimensionText("1/m", "a value per length", "-0.016 1/mm");
const $c7928 = new DimensionText("m3/J", "a wear volume per energy", "0.05 mm3/J");
const $c3ce8 = new DimensionText("J/m2", "an energy per area", "800 J/m2");
const $c46d3 = new DimensionText("W/m2", "a power per area", "1500 W/m2");
const $c3fd6 = new DimensionText("rad/s", "a rotation speed", "71.6 rpm");
const $c9bfd = new DimensionText("Hz", "a frequency", "1.2 Hz");
const $cd5cc = new DimensionText("kg", "a mass", "500 kg");
const $c622e = new DimensionText("kg/m", "a mass per length", "22 kg/m");
const $c5b93 = new DimensionText("kg/s", "a mass flow", "1500 t/h");
const $ca074 = new DimensionText("kg/m3", "a density", "1600 kg/m3");
const $c96d5 = new DimensionText("kg m2", "a moment of inertia", "2200 kg m2");
const $c78b8 = new DimensionText("", "a plain number", "0.35");
const $c22c8 = new Map([["length", $c4c89], ["force", $cb7f2], ["force_per_width", $ceb3f], ["spring_rate", $cb6a4], ["pressure", $c6907], ["pressure_per_length", $cabbc], ["speed", $c12ff], ["angle", $ca5a3], ["power", $ca327], ["torque", $c19d7], ["area", $cc5a9], ["time", $c9e8e], ["temperature", $c5e0b], ["per_length", $c32f4], ["wear_coefficient", $c7928], ["energy_per_area", $c3ce8], ["power_per_area", $c46d3], ["rotation_speed", $c3fd6], ["frequency", $c9bfd], ["mass", $cd5cc], ["mass_per_length", $c622e], ["mass_flow", $c5b93], ["density", $ca074], ["moment_of_inertia", $c96d5], ["number", $c78b8]]);
const $c1360 = ["ton", "tons", "Ton", "Tons", "TON", "TONS", "tn", "tns"];
const $c33fe = ["mass", "mass_per_length", "mass_flow", "density", "moment_of_inertia"];
const $c388d = ["kg", "m", "s", "K", "rad"];
const $c7520 = ["meter", "meters", "metre", "metres"];
const $c3ab7 = $Decimal.of("1");
const $cff3b = $Decimal.of("0");
const $ca016 = new Definition($c7520, $c3ab7, "m", $cff3b);
const $cc6d3 = ["km"];
const $ceae1 = $Decimal.of("1000");
const $cb0fe = $Decimal.of("0");
const $cac85 = new Definition($cc6d3, $ceae1, "m", $cb0fe);
const $c463e = ["dm"];
const $cfce2 = $Decimal.of("0.1");
const $c9df0 = $Decimal.of("0");
const $c6c44 = new Definition($c463e, $cfce2, "m", $c9df0);
const $cb9ee = ["cm"];
const $c5a49 = $Decimal.of("0.01");
const $c6f7a = $Decimal.of("0");
const $c23b7 = new Definition($cb9ee, $c5a49, "m", $c6f7a);
const $c292c = ["mm"];
const $cdda8 = $Decimal.of("0.001");
const $cf90c = $Decimal.of("0");
const $c898e = new Definition($c292c, $cdda8, "m", $cf90c);
const $c7835 = ["um", "micron", "microns"];
const $c74d8 = $Decimal.of("0.000001");
const $c1807 = $Decimal.of("0");
const $c3cf3 = new Definition($c7835, $c74d8, "m", $c1807);
const $ca74f = ["in", "inch", "inches", "\""];
const $c417c = $Decimal.of("0.0254");
const $c8466 = $Decimal.of("0");
const $c78b2 = new Definition($ca74f, $c417c, "m", $c8466);
const $c6149 = ["ft", "foot", "feet"];
const $c4b0c = $Decimal.of("12");
const $cf9db = $Decimal.of("0");
const $cfead = new Definition($c6149, $c4b0c, "in", $cf9db);
const $cb28d = ["yd"];
const $cd476 = $Decimal.of("3");
const $c455d = $Decimal.of("0");
const $cc559 = new Definition($cb28d, $cd476, "ft", $c455d);
const $ca080 = ["mi", "mile", "miles"];
const $cd70f = $Decimal.of("5280");
const $c99ca = $Decimal.of("0");
const $cc34c = new Definition($ca080, $cd70f, "ft", $c99ca);
const $c990f = ["thou"];
const $c15de = $Decimal.of("0.001");
const $c479a = $Decimal.of("0");
const $c06a3 = new Definition($c990f, $c15de, "in", $c479a);
const $c8108 = ["g"];
const $c0115 = $Decimal.of("0.001");
const $c3c60 = $Decimal.of("0");
const $c4a6d = new Definition($c8108, $c0115, "kg", $c3c60);
const $cd35b = ["t", "tonne", "tonnes"];
const $c2b42 = $Decimal.of("1000");
const $c213b = $Decimal.of("0");
const $c2b63 = new Definition($cd35b, $c2b42, "kg", $c213b);
const $cea9f = ["lbm"];
const $cbce9 = $Decimal.of("0.45359237");
const $cd3b3 = $Decimal.of("0");
const $c32bf = new Definition($cea9f, $cbce9, "kg", $cd3b3);
const $c1a95 = ["ston", "stons"];
const $c7d8d = $Decimal.of("2000");
const $c0b23 = $Decimal.of("0");
const $cb3fe = new Definition($c1a95, $c7d8d, "lbm", $c0b23);
const $c8c7b = ["lton", "ltons"];
const $cd553 = $Decimal.of("2240");
const $c3630 = $Decimal.of("0");
const $c926d = new Definition($c8c7b, $cd553, "lbm", $c3630);
const $c5316 = ["sec", "second", "seconds"];
const $c51e3 = $Decimal.of("1");
const $c6250 = $Decimal.of("0");
const $ccfac = new Definition($c5316, $c51e3, "s", $c6250);
const $c5307 = ["ms"];
const $c2d60 = $Decimal.of("0.001");
const $c79b7 = $Decimal.of("0");
const $c3fb9 = new Definition($c5307, $c2d60, "s", $c79b7);
const $cfa63 = ["min", "minute", "minutes"];
const $c4448 = $Decimal.of("60");
const $c6b3e = $Decimal.of("0");
const $cc25d = new Definition($cfa63, $c4448, "s", $c6b3e);
const $ce15c = ["h", "hr", "hour", "hours"];
const $c89f6 = $Decimal.of("60");
const $cfd46 = $Decimal.of("0");
const $c8a0e = new Definition($ce15c, $c89f6, "min", $cfd46);
const $ce156 = ["d", "day", "days"];
const $c8ef1 = $Decimal.of("24");
const $c91d2 = $Decimal.of("0");
const $c85fe = new Definition($ce156, $c8ef1, "h", $c91d2);
const $cf758 = ["N", "newton", "newtons"];
const $c63be = $Decimal.of("1");
const $c33c6 = $Decimal.of("0");
const $cf7d5 = new Definition($cf758, $c63be, "kg m/s2", $c33c6);
const $ce5c1 = ["mN"];
const $cf74a = $Decimal.of("0.001");
const $cc8a6 = $Decimal.of("0");
const $ccd2e = new Definition($ce5c1, $cf74a, "N", $cc8a6);
const $c0970 = ["daN"];
const $c3af5 = $Decimal.of("10");
const $cd65e = $Decimal.of("0");
const $cb833 = new Definition($c0970, $c3af5, "N", $cd65e);
const $c2d83 = ["kN"];
const $c7ef1 = $Decimal.of("1000");
const $cc92e = $Decimal.of("0");
const $cc894 = new Definition($c2d83, $c7ef1, "N", $cc92e);
const $c3dda = ["MN"];
const $cfffc = $Decimal.of("1E+6");
const $c1650 = $Decimal.of("0");
const $cb72b = new Definition($c3dda, $cfffc, "N", $c1650);
const $c9381 = ["kgf", "kp"];
const $cb65f = $Decimal.of("9.80665");
const $cf513 = $Decimal.of("0");
const $c2cce = new Definition($c9381, $cb65f, "N", $cf513);
const $c9b51 = ["gf"];
const $c6c62 = $Decimal.of("0.001");
const $cafa5 = $Decimal.of("0");
const $c6462 = new Definition($c9b51, $c6c62, "kgf", $cafa5);
const $c0316 = ["tf"];
const $c0ee7 = $Decimal.of("1000");
const $c5df2 = $Decimal.of("0");
const $cc08f = new Definition($c0316, $c0ee7, "kgf", $c5df2);
const $c7445 = ["lbf", "lb", "lbs"];
const $c0294 = $Decimal.of("4.4482216152605");
const $c0292 = $Decimal.of("0");
const $c4056 = new Definition($c7445, $c0294, "N", $c0292);
const $cb751 = ["klbf", "kip", "kips"];
const $cd29e = $Decimal.of("1000");
const $cfe19 = $Decimal.of("0");
const $cfb47 = new Definition($cb751, $cd29e, "lbf", $cfe19);
const $c8aef = ["PIW", "piw", "PLI", "pli"];
const $c8d62 = $Decimal.of("1");
const $cb5ab = $Decimal.of("0");
const $cde5a = new Definition($c8aef, $c8d62, "lbf/in", $cb5ab);
const $c3a72 = ["Pa"];
const $c02fd = $Decimal.of("1");
const $cb107 = $Decimal.of("0");
const $c7e30 = new Definition($c3a72, $c02fd, "N/m2", $cb107);
const $c52a1 = ["hPa"];
const $ce59e = $Decimal.of("100");
const $cf530 = $Decimal.of("0");
const $c3856 = new Definition($c52a1, $ce59e, "Pa", $cf530);
const $c42a0 = ["kPa"];
const $c0cd3 = $Decimal.of("1000");
const $cfb15 = $Decimal.of("0");
const $c9971 = new Definition($c42a0, $c0cd3, "Pa", $cfb15);
const $ca16d = ["MPa"];
const $c961c = $Decimal.of("1E+6");
const $c1f76 = $Decimal.of("0");
const $c6f8da = new Definition($ca16d, $c961c, "Pa", $c1f76);
const $c3c10 = ["GPa"];
const $c0c4a = $Decimal.of("1E+9");
const $cf60c = $Decimal.of("0");
const $ce4e2 = new Definition($c3c10, $c0c4a, "Pa", $cf60c);
const $cde67 = ["bar"];
const $cbe29 = $Decimal.of("1E+5");
const $cb58f = $Decimal.of("0");
const $c56ee = new Definition($cde67, $cbe29, "Pa", $cb58f);
const $c50e9 = ["mbar"];
const $c94dc = $Decimal.of("100");
const $c5af7 = $Decimal.of("0");
const $cf9cc = new Definition($c50e9, $c94dc, "Pa", $c5af7);
const $c4a77 = ["psi", "PSI"];
const $c56b5 = $Decimal.of("1");
const $c1805 = $Decimal.of("0");
const $c390e = new Definition($c4a77, $c56b5, "lbf/in2", $c1805);
const $c5f66 = ["ksi"];
const $c1a1a = $Decimal.of("1000");
const $c4846 = $Decimal.of("0");
const $c1150 = new Definition($c5f66, $c1a1a, "psi", $c4846);
const $cedae = ["J", "joule"];
const $c5094 = $Decimal.of("1");
const $ce0a7 = $Decimal.of("0");
const $cd0b2 = new Definition($cedae, $c5094, "N m", $ce0a7);
const $c173c = ["mJ"];
const $ce6bf = $Decimal.of("0.001");
const $cbf07 = $Decimal.of("0");
const $ca59d = new Definition($c173c, $ce6bf, "J", $cbf07);
const $c968b = ["kJ"];
const $c72b7 = $Decimal.of("1000");
const $c8a50 = $Decimal.of("0");
const $cb500 = new Definition($c968b, $c72b7, "J", $c8a50);
const $c28c4 = ["MJ"];
const $c8da2 = $Decimal.of("1E+6");
const $c7602 = $Decimal.of("0");
const $c5f67 = new Definition($c28c4, $c8da2, "J", $c7602);
const $c8ceb = ["Nm"];
const $c449e = $Decimal.of("1");
const $c585b = $Decimal.of("0");
const $c13af = new Definition($c8ceb, $c449e, "N m", $c585b);
const $cabe7 = ["kNm"];
const $cbf90 = $Decimal.of("1000");
const $cde15 = $Decimal.of("0");
const $c87eb = new Definition($cabe7, $cbf90, "N m", $cde15);
const $c2d10 = ["MNm"];
const $c3007 = $Decimal.of("1E+6");
const $ceb26 = $Decimal.of("0");
const $c7072 = new Definition($c2d10, $c3007, "N m", $ceb26);
const $cb812 = ["W", "watt", "watts"];
const $c356d = $Decimal.of("1");
const $c0c48 = $Decimal.of("0");
const $cdb72 = new Definition($cb812, $c356d, "J/s", $c0c48);
const $c3722 = ["kW"];
const $c3a01 = $Decimal.of("1000");
const $cd854 = $Decimal.of("0");
const $ccb08 = new Definition($c3722, $c3a01, "W", $cd854);
const $c00c1 = ["MW"];
const $c18c5 = $Decimal.of("1E+6");
const $ccd40 = $Decimal.of("0");
const $c875c = new Definition($c00c1, $c18c5, "W", $ccd40);
const $c13bc = ["hp", "HP", "bhp", "BHP"];
const $c29ff = $Decimal.of("550");
const $ceadb = $Decimal.of("0");
const $ce000 = new Definition($c13bc, $c29ff, "ft lbf/s", $ceadb);
const $c9d69 = ["PS", "cv", "CV", "hp(metric)"];
const $cf5e2 = $Decimal.of("75");
const $c1241 = $Decimal.of("0");
const $cc241 = new Definition($c9d69, $cf5e2, "kgf m/s", $c1241);
const $c9e5a = ["fpm", "FPM"];
const $c20e8 = $Decimal.of("1");
const $c50c0 = $Decimal.of("0");
const $c8730 = new Definition($c9e5a, $c20e8, "ft/min", $c50c0);
const $c9bb9 = ["fps"];
const $c8451 = $Decimal.of("1");
const $c835f = $Decimal.of("0");
const $c3d60 = new Definition($c9bb9, $c8451, "ft/s", $c835f);
const $c0cf2 = ["mps"];
const $ca9a1 = $Decimal.of("1");
const $ccf02 = $Decimal.of("0");
const $cde8d = new Definition($c0cf2, $ca9a1, "m/s", $ccf02);
const $ca81f = ["kph", "kmh"];
const $c8247 = $Decimal.of("1");
const $cc69c = $Decimal.of("0");
const $c529e = new Definition($ca81f, $c8247, "km/h", $cc69c);
const $ce6a6 = ["mph"];
const $ceebe = $Decimal.of("1");
const $cad07 = $Decimal.of("0");
const $c7f4c = new Definition($ce6a6, $ceebe, "mi/h", $cad07);
const $cc5e5 = ["tph", "TPH", "mtph", "MTPH"];
const $cb7ee = $Decimal.of("1");
const $c0989 = $Decimal.of("0");
const $c3c78 = new Definition($cc5e5, $cb7ee, "t/h", $c0989);
const $c9a35 = ["stph", "STPH"];
const $c9b87 = $Decimal.of("1");
const $cf2a2 = $Decimal.of("0");
const $c3224 = new Definition($c9a35, $c9b87, "ston/h", $cf2a2);
const $c3df0 = ["ltph", "LTPH"];
const $c61b0 = $Decimal.of("1");
const $c036f = $Decimal.of("0");
const $c1c86 = new Definition($c3df0, $c61b0, "lton/h", $c036f);
const $c3b25 = ["Hz", "hertz"];
const $cacd0 = $Decimal.of("1");
const $cb554 = $Decimal.of("0");
const $c8ea2 = new Definition($c3b25, $cacd0, "1/s", $cb554);
const $cfa95 = ["mrad"];
const $c2c57 = $Decimal.of("0.001");
const $c80ad = $Decimal.of("0");
const $c10f2 = new Definition($cfa95, $c2c57, "rad", $c80ad);
const $c315a = ["deg", "degree", "degrees", "°"];
const $cdc92 = $Decimal.of("0.01745329251994329576923690768");
const $cd8a7 = $Decimal.of("0");
const $c4bbe = new Definition($c315a, $cdc92, "rad", $cd8a7);
const $c3235 = ["rev", "turn", "turns"];
const $c691f = $Decimal.of("360");
const $ca1a42 = $Decimal.of("0");
const $caf6b = new Definition($c3235, $c691f, "deg", $ca1a42);
const $c80c3 = ["rpm", "RPM"];
const $c5fe7 = $Decimal.of("1");
const $c679a = $Decimal.of("0");
const $c029a = new Definition($c80c3, $c5fe7, "rev/min", $c679a);
const $c0b62 = ["degC", "°C"];
const $c6bff = $Decimal.of("1");
const $c2f8d = $Decimal.of("-273.15");
const $c8cd2 = new Definition($c0b62, $c6bff, "K", $c2f8d);
const $c04d0 = ["degF", "°F"];
const $ce4e9 = $Decimal.of("0.5555555555555555555555555556");
const $c91b1 = $Decimal.of("-459.67");
const $cfa62 = new Definition($c04d0, $ce4e9, "K", $c91b1);
const $ca7a5 = ["%", "percent"];
const $c307b = $Decimal.of("0.01");
const $c0a42 = $Decimal.of("0");
const $c83b1 = new Definition($ca7a5, $c307b, "", $c0a42);
const $c50ba = [$ca016, $cac85, $c6c44, $c23b7, $c898e, $c3cf3, $c78b2, $cfead, $cc559, $cc34c, $c06a3, $c4a6d, $c2b63, $c32bf, $cb3fe, $c926d, $ccfac, $c3fb9, $cc25d, $c8a0e, $c85fe, $cf7d5, $ccd2e, $cb833, $cc894, $cb72b, $c2cce, $c6462, $cc08f, $c4056, $cfb47, $cde5a, $c7e30, $c3856, $c9971, $c6f8da, $ce4e2, $c56ee, $cf9cc, $c390e, $c1150, $cd0b2, $ca59d, $cb500, $c5f67, $c13af, $c87eb, $c7072, $cdb72, $ccb08, $c875c, $ce000, $cc241, $c8730, $c3d60, $cde8d, $c529e, $c7f4c, $c3c78, $c3224, $c1c86, $c8ea2, $c10f2, $c4bbe, $caf6b, $c029a, $c8cd2, $cfa62, $c83b1];
const $cdac1 = new Map([[181, "u"], [956, "u"], [8243, "\""], [8221, "\""], [186, "°"], [183, "*"], [8901, "*"], [215, "*"], [178, "2"], [179, "3"], [8315, "-"], [185, "1"], [160, " "], [8239, " "]]);
const $c0fad = $re("(?<over>1|[A-Za-z°%\"]+(?:\\^?-?[1-9])?(?:(?:\\s*[*.]\\s*|\\s+|-(?=[A-Za-z]))[A-Za-z°%\"]+(?:\\^?-?[1-9])?)*)?\\s*(?:/\\s*(?:(?<one>[A-Za-z°%\"]+(?:\\^?-?[1-9])?)|\\(\\s*(?<under>[A-Za-z°%\"]+(?:\\^?-?[1-9])?(?:(?:\\s*[*.]\\s*|\\s+|-(?=[A-Za-z]))[A-Za-z°%\"]+(?:\\^?-?[1-9])?)*)\\s*\\)))?", "");
const $c09cc = $re("([A-Za-z°%\"]+)(?:\\^?(-?[1-9]))?", "");
const $c5fbb = ["length", "force", "force_per_width", "spring_rate", "pressure", "pressure_per_length", "speed", "angle", "power", "torque", "area", "time", "temperature", "per_length", "wear_coefficient", "energy_per_area", "power_per_area", "rotation_speed", "frequency", "mass", "mass_per_length", "mass_flow", "density", "moment_of_inertia", "number"];
const $c8940 = $re("\\bkg(?![A-Za-z])", "");
const $c47ac = [$c8940, "kgf", "a force"];
const $c221f = $re("\\bkgf(?![A-Za-z])", "");
const $ce538 = [$c221f, "kg", "a mass"];
const $cc1df = $re("\\bt(?![A-Za-z])", "");
const $c121a = [$cc1df, "tf", "a force"];
const $c6b53 = $re("\\btf(?![A-Za-z])", "");
const $c4fa4 = [$c6b53, "t", "a mass"];
const $c4039 = $re("\\bg(?![A-Za-z])", "");
const $c5514 = [$c4039, "gf", "a force"];
const $c37b1 = $re("\\bgf(?![A-Za-z])", "");
const $c14d5 = [$c37b1, "g", "a mass"];
const $c6c84 = $re("\\blbm(?![A-Za-z])", "");
const $c5cd7 = [$c6c84, "lbf", "a force"];
const $c4fa8 = $re("\\blbf(?![A-Za-z])", "");
const $c907a = [$c4fa8, "lbm", "a mass"];
const $ca649 = [$c47ac, $ce538, $c121a, $c4fa4, $c5514, $c14d5, $c5cd7, $c907a];
const $c7c8f = $re("[+-]?(?:[0-9]+(?:\\.[0-9]*)?|\\.[0-9]+)(?:[eE][+-]?[0-9]+)?", "");
const $cf327 = $re("[0-9.,'’_´`\\s+\\-−/:;]*(?:(?<=[0-9])[eE][+-]?[0-9]+)?", "");
const $ccb7f = $re("[+-]?\\s*(?:nan|inf|infinity|∞)\\b", "i");
const $c0f01 = $re("[eE][+-]?([0-9]+)$", "");
const $ced43 = $re("(?<=[0-9])[\\s'’_´`]+(?=[0-9])", "");
const $cb5cc = $re("[,.]", "");
const $cf432 = $re("1\\s*/\\s*[A-Za-z(]", "");
const $c9926 = $re("[0-9.,'’_´`+\\-−:;]|/\\s*[0-9]", "");
const $c3d44 = [62.0, 1250.0];
const $c1fa2 = $re("(?:(?:DIN|ISO|EN|AS|IS|GB/T|JIS)\\s*(?:EN\\s*)?[A-Z]?\\s*\\d+\\S*\\s+(?:[A-Z]{1,4}\\s+)?)?(?:B?\\s*\\d{3,4}\\s*(?:MM)?\\s+)?ST\\s*-?\\s*/?(?<strength>\\d{2,6})(?![\\d])(?:\\s*[-,]?\\s*(?:(?<carry>\\d+(?:[.,]\\d+)?)\\s*(?:MM)?\\s*[TS]?\\s*[-+/:X]\\s*(?<pulley>\\d+(?:[.,]\\d+)?)\\s*(?:MM)?|(?<top>\\d+/\\d+)\\s*(?:IN\\b|\")?\\s*[-+:X]\\s*(?<bottom>\\d+/\\d+)\\s*(?:IN\\b|\")?))?(?<grade>(?:\\s*[-,]?\\s*[A-Z][A-Z0-9]{0,6}(?:(?:\\s+|\\s*[-,]\\s*)(?:[A-Z][A-Z0-9]{0,6}|\\d{2,5}(?:\\s?MM)?)){0,4})?(?:\\s+B?\\d{3,4}\\s?MM)?)\\s*", "");
const $c348c = $re("(?<strength>\\d{2,4})\\s*(?:PIW|PLI)\\b(?:\\s*[-/,]?\\s*(?<plies>\\d)(?:[\\s-]*PLY|[\\s-]*PLIES|\\b(?![/.,\\d])))?(?:\\s*[-,]?\\s*(?:(?<carry>\\d+(?:[.,]\\d+)?)\\s*(?:MM)?\\s*[TS]?\\s*[-+/:X]\\s*(?<pulley>\\d+(?:[.,]\\d+)?)\\s*(?:MM)?|(?<top>\\d+/\\d+)\\s*(?:IN\\b|\")?\\s*[-+:X]\\s*(?<bottom>\\d+/\\d+)\\s*(?:IN\\b|\")?))?(?<grade>(?:\\s*[-,]?\\s*[A-Z][A-Z0-9]{0,6}(?:(?:\\s+|\\s*[-,]\\s*)(?:[A-Z][A-Z0-9]{0,6}|\\d{2,5}(?:\\s?MM)?)){0,4})?(?:\\s+B?\\d{3,4}\\s?MM)?)\\s*", "");
const $c3b22 = $re("(?<plies>\\d)(?:[\\s-]*PLY|[\\s-]*PLIES|\\s*[-/])\\s*(?<strength>\\d{2,4})\\s*(?:PIW|PLI)\\b(?:\\s*[-,]?\\s*(?:(?<carry>\\d+(?:[.,]\\d+)?)\\s*(?:MM)?\\s*[TS]?\\s*[-+/:X]\\s*(?<pulley>\\d+(?:[.,]\\d+)?)\\s*(?:MM)?|(?<top>\\d+/\\d+)\\s*(?:IN\\b|\")?\\s*[-+:X]\\s*(?<bottom>\\d+/\\d+)\\s*(?:IN\\b|\")?))?(?<grade>(?:\\s*[-,]?\\s*[A-Z][A-Z0-9]{0,6}(?:(?:\\s+|\\s*[-,]\\s*)(?:[A-Z][A-Z0-9]{0,6}|\\d{2,5}(?:\\s?MM)?)){0,4})?(?:\\s+B?\\d{3,4}\\s?MM)?)\\s*", "");
const $cbcbe = $re("(?:PIW|PLI)\\s*(?<strength>\\d{2,4})\\s*(?:/\\s*(?<plies>\\d)(?![\\d/]))?(?:\\s*[-,]?\\s*(?:(?<carry>\\d+(?:[.,]\\d+)?)\\s*(?:MM)?\\s*[TS]?\\s*[-+/:X]\\s*(?<pulley>\\d+(?:[.,]\\d+)?)\\s*(?:MM)?|(?<top>\\d+/\\d+)\\s*(?:IN\\b|\")?\\s*[-+:X]\\s*(?<bottom>\\d+/\\d+)\\s*(?:IN\\b|\")?))?(?<grade>(?:\\s*[-,]?\\s*[A-Z][A-Z0-9]{0,6}(?:(?:\\s+|\\s*[-,]\\s*)(?:[A-Z][A-Z0-9]{0,6}|\\d{2,5}(?:\\s?MM)?)){0,4})?(?:\\s+B?\\d{3,4}\\s?MM)?)\\s*", "");
const $caeec = [$c348c, $c3b22, $cbcbe];
const $c77e8 = $re("(?:[A-Z]{1,3}\\s*-?\\s*)?[\\dOIL]{2,6}\\s*[-/:X]\\s*[\\dOIL]{1,2}\\b.*|ST\\W*\\w{2,6}", "");
const $c6b5d = new Usual(10.0, 8.0, 10.0);
const $c79d4 = new Usual(6.666666666666667, 6.666666666666667, 7.0);
const $c60ad = new Map([["fabric", $c6b5d], ["steel cord", $c79d4]]);
const $c22da = new Map([["fabric", "Roulunds, conveyor belts, 2001; Neelkanth Beltings, selection chart"], ["steel cord", "Goodyear EP conveyor belt catalogue (Flexsteel), 2012, p. 71; Forech, steel cord belts"]]);
const $cdd13 = new Usual(7.5, 5.0, 12.0);
const $cad69 = new Usual(7.5, 5.0, 12.0);
const $c3253 = new Usual(10.5, 5.0, 12.0);
const $cdd66 = new Usual(4.0, 2.5, 5.0);
const $cfe41 = new Usual(7.5, 5.0, 12.0);
const $c2fbf = new Usual(72.0, 50.0, 72.0);
const $c88e4 = new Map([["EP", $cdd13], ["PN", $cad69], ["EE", $c3253], ["NN", $cdd66], ["PIW", $cfe41], ["ST", $c2fbf]]);
const $c849a = new Map([["EP", "Goodyear EP conveyor belt catalogue, 2012, p. 15; elongation at a tenth of the strength, DIN 22102"], ["PN", "Goodyear EP conveyor belt catalogue, 2012, p. 15; elongation at a tenth of the strength, DIN 22102"], ["EE", "Goodyear EP conveyor belt catalogue, 2012, p. 15; elongation at a tenth of the strength, DIN 22102"], ["PIW", "Goodyear EP conveyor belt catalogue, 2012, p. 15; elongation at a tenth of the strength, DIN 22102"], ["NN", "JD Conveyor, elongation of NN and EP fabric; GB/T 7984, at most 4 %"], ["ST", "Goodyear EP conveyor belt catalogue (Flexsteel), 2012, p. 71; Sempertrans, data sheet of ST 1000, 2014"]]);
const $c322a = new Cords(0.0037, NaN, "NRC Industries, steel cord belts");
const $ceaf6 = new Cords(0.0037, NaN, "NRC Industries, steel cord belts");
const $c7108 = new Cords(0.0037, 0.015, "DIN 22131, ISO 15236-2; NRC Industries, steel cord belts, and BVH Rubber");
const $c2622 = new Cords(0.0039, 0.012, "DIN 22131, ISO 15236-2; NRC Industries, steel cord belts, and BVH Rubber");
const $c27db = new Cords(0.0047, 0.014, "DIN 22131, ISO 15236-2; NRC Industries, steel cord belts, and BVH Rubber");
const $cd1cb = new Cords(0.0047, NaN, "NRC Industries, steel cord belts");
const $c98e2 = new Cords(0.0054, 0.015, "DIN 22131, ISO 15236-2; NRC Industries, steel cord belts, and BVH Rubber");
const $ceac6 = new Cords(0.0054, NaN, "NRC Industries, steel cord belts");
const $c19cc = new Cords(0.0054, 0.012, "DIN 22131, ISO 15236-2; NRC Industries, steel cord belts, and BVH Rubber");
const $c8595 = new Cords(0.0062, NaN, "NRC Industries, steel cord belts");
const $cf8b8 = new Cords(0.007, 0.015, "DIN 22131, ISO 15236-2; NRC Industries, steel cord belts, and BVH Rubber");
const $c902a = new Cords(0.0072, NaN, "NRC Industries, steel cord belts");
const $c1bd2 = new Cords(0.0081, 0.015, "DIN 22131, ISO 15236-2; NRC Industries, steel cord belts, and BVH Rubber");
const $ccf9c = new Cords(0.0086, 0.015, "DIN 22131, ISO 15236-2; NRC Industries, steel cord belts, and BVH Rubber");
const $c4a9b = new Cords(0.0089, 0.015, "DIN 22131, ISO 15236-2; NRC Industries, steel cord belts, and BVH Rubber");
const $c4a21 = new Cords(0.0097, 0.016, "DIN 22131, ISO 15236-2; NRC Industries, steel cord belts, and BVH Rubber");
const $c3db8 = new Cords(0.0109, 0.017, "DIN 22131, ISO 15236-2; NRC Industries, steel cord belts, and BVH Rubber");
const $ccc94 = new Cords(0.0113, 0.017, "DIN 22131, ISO 15236-2; NRC Industries, steel cord belts, and BVH Rubber");
const $ca5a1 = new Cords(0.0124, 0.0216, "Goodyear EP conveyor belt catalogue (Flexsteel), 2012, p. 71");
const $c32d7 = new Cords(0.0124, 0.0201, "Goodyear EP conveyor belt catalogue (Flexsteel), 2012, p. 71");
const $c75dc = new Cords(0.0124, 0.0188, "Goodyear EP conveyor belt catalogue (Flexsteel), 2012, p. 71");
const $c9cad = new Map([[500, $c322a], [630, $ceaf6], [800, $c7108], [1000, $c2622], [1250, $c27db], [1400, $cd1cb], [1600, $c98e2], [1800, $ceac6], [2000, $c19cc], [2250, $c8595], [2500, $cf8b8], [2800, $c902a], [3150, $c1bd2], [3500, $ccf9c], [4000, $c4a9b], [4500, $c4a21], [5000, $c3db8], [5400, $ccc94], [6000, $ca5a1], [6500, $c32d7], [7000, $c75dc]]);
const $cb302 = new Map([["fabric", "Goodyear EP conveyor belt catalogue, 2012, p. 15; Neelkanth Beltings, selection chart"], ["steel cord", "Goodyear EP conveyor belt catalogue (Flexsteel), 2012, p. 71"]]);
const $ca34d = [0.8, 1.4];
const $c552c = ["EP", "NN"];
const $c0bbc = ["EE", "NN"];
const $cc26f = new Map([["P", $c552c], ["PP", $c0bbc]]);
const $cf010 = [0.8, 1.25];
const $c4e18 = new Map([["EP", "Neelkanth Beltings, selection chart; Monster Belting, plies; Goodyear EP conveyor belt catalogue, 2012, p. 15"], ["NN", "Tatanka, NN belts; Monster Belting, plies"]]);
const $c197d = new Map([["EP", 108.0], ["PN", 108.0], ["EE", 108.0], ["PIW", 108.0], ["NN", 90.0], ["ST", 145.0]]);
const $c4076 = [0.2, 0.25, 0.315, 0.4, 0.5, 0.63, 0.8, 1.0, 1.25, 1.4, 1.6, 1.8, 2.0];
const $c2628 = ["name", "kind", "modulus", "modulus_test", "modulus_loads", "modulus_ends", "rating", "strength", "least_pulley_diameter", "pulley_cover", "carry_cover", "carcass", "carcass_ends", "cord_pitch"];
const $c5884 = ["modulus_test", "modulus_loads", "modulus_ends"];
const $c2a894 = new Map([["width", $c1da4], ["modulus", $c5a26], ["rating", $c4bc3], ["strength", $c3eaf], ["speed", $c45b0], ["momentary_factor", $cfb5f], ["least_pulley_diameter", $cbc30], ["largest_wrap_pressure", $cf3a1], ["in_plane_shear_stiffness", $cd676], ["pulley_cover", $cbe31], ["carry_cover", $ca3d0], ["carcass", $c9b33], ["thickness", $cbf1f], ["cover_shear_modulus", $c975b], ["cord_diameter", $c7e3d], ["cord_pitch", $c26ab], ["mass", $ce1b5]]);
const $ced64 = new Set(["carcass", "cord_diameter", "thickness"]);
const $c2d22 = ["pulley_cover", "carry_cover", "carcass"];
const $ca366 = $re("[A-Za-z0-9_-]{1,60}", "");
const $c2e28 = ["diameter", "wrap_angle", "entry_tension", "exit_tension", "effective_tension"];
const $c39fc = ["x", "y", "diameter", "turn"];
const $c2e3c = [10000, "m"];
const $c68da = [$c2e3c];
const $c03b4 = ["mm", $c68da];
const $cc67d = ["kN", []];
const $ce2c9 = ["kN/m", []];
const $c6fe9 = [10000, "MPa"];
const $c76c4 = [$c6fe9];
const $c0183 = ["kPa", $c76c4];
const $cb046 = ["kPa/mm", []];
const $cb323f = ["m/s", []];
const $c152b = ["deg", []];
const $c1a85 = ["kW", []];
const $cd5b6 = ["kN m", []];
const $c2e60 = ["m2", []];
const $ca9e4 = ["s", []];
const $c4129 = ["degC", []];
const $c48ee = ["1/mm", []];
const $ce81f = ["mm3/J", []];
const $c13c5 = [1000000, "MJ/m2"];
const $cc2e2 = [$c13c5];
const $c414b = ["J/m2", $cc2e2];
const $cb45a = [10000, "kW/m2"];
const $c6402 = [$cb45a];
const $c0650 = ["W/m2", $c6402];
const $cad55 = ["rpm", []];
const $c0dc7 = ["Hz", []];
const $c3ec9 = ["kg", []];
const $c9e28 = ["kg/m", []];
const $c19db = ["t/h", []];
const $c51a0 = ["kg/m3", []];
const $c77e7 = ["kg m2", []];
const $c8dba = ["", []];
const $c0579 = new Map([["length", $c03b4], ["force", $cc67d], ["force_per_width", $ce2c9], ["spring_rate", $ce2c9], ["pressure", $c0183], ["pressure_per_length", $cb046], ["speed", $cb323f], ["angle", $c152b], ["power", $c1a85], ["torque", $cd5b6], ["area", $c2e60], ["time", $ca9e4], ["temperature", $c4129], ["per_length", $c48ee], ["wear_coefficient", $ce81f], ["energy_per_area", $c414b], ["power_per_area", $c0650], ["rotation_speed", $cad55], ["frequency", $c0dc7], ["mass", $c3ec9], ["mass_per_length", $c9e28], ["mass_flow", $c19db], ["density", $c51a0], ["moment_of_inertia", $c77e7], ["number", $c8dba]]);
const $c3dc7 = [400, "ft"];
const $cc9da = [$c3dc7];
const $ce165 = ["in", $cc9da];
const $c4fdf = ["lbf", []];
const $c954e = ["PIW", []];
const $c8199 = ["lbf/in", []];
const $c715c = [10000, "ksi"];
const $cc6d2 = [$c715c];
const $c90b1 = ["psi", $cc6d2];
const $c4989 = ["psi/in", []];
const $cc6c2 = ["fpm", []];
const $c8b51 = ["hp", []];
const $c2254 = ["lbf ft", []];
const $c98a4 = ["in2", []];
const $cda43 = ["degF", []];
const $c59e7 = ["1/in", []];
const $ca33a = ["in3/(ft lbf)", []];
const $c6d8d = ["ft lbf/ft2", []];
const $c453a = ["hp/ft2", []];
const $ce38a = ["lbm", []];
const $c7fbf = ["lbm/ft", []];
const $c6da4 = ["lbm/h", []];
const $c814b = ["lbm/ft3", []];
const $ca456 = ["lbm ft2", []];
const $cbe21 = new Map([["length", $ce165], ["force", $c4fdf], ["force_per_width", $c954e], ["spring_rate", $c8199], ["pressure", $c90b1], ["pressure_per_length", $c4989], ["speed", $cc6c2], ["angle", $c152b], ["power", $c8b51], ["torque", $c2254], ["area", $c98a4], ["time", $ca9e4], ["temperature", $cda43], ["per_length", $c59e7], ["wear_coefficient", $ca33a], ["energy_per_area", $c6d8d], ["power_per_area", $c453a], ["rotation_speed", $cad55], ["frequency", $c0dc7], ["mass", $ce38a], ["mass_per_length", $c7fbf], ["mass_flow", $c6da4], ["density", $c814b], ["moment_of_inertia", $ca456], ["number", $c8dba]]);
const $cd5a9 = new Map([["si", $c0579], ["us", $cbe21]]);
const $c535d = ["kind", "source", "date", "note"];
const $c2aaf = $made(Provenance, $c535d, ["given", "", "", "from the coordinates of the pulleys"]);
const $c6fe1 = ["entry_tension", "exit_tension", "effective_tension", "torque", "power"];
const $cf50e = [$cdc1c, $c25c2, $cdb8f, $c490f, $c1441];
const $c7939 = new Map([["entry", "entry_tension"], ["exit", "exit_tension"]]);
const $c26fe = ["entry_tension", "exit_tension", "effective_tension"];
const $cee7f = ["flight", $c1b6f, "flights"];
const $cab86 = ["loading", $ce67f, "loadings"];
const $c6b73 = ["drive", $cc308, "drives"];
const $c2ef3 = ["resistance", $c40f1, "locals"];
const $ca4a5 = [$cee7f, $cab86, $c6b73, $c2ef3];
const $cac72 = ["friction_factor", "length_coefficient", "secondary_resistance", "special_resistance", "material_mass", "capacity", "belt_mass", "carry_idler_mass", "return_idler_mass", "lift", "start_factor", "take_up_tension", "counterweight"];
const $c01d0 = ["material_mass", "capacity", "material_mass = \"120 kg/m\""];
const $cab98 = ["take_up_tension", "counterweight", "take_up_tension = \"40 kN\""];
const $c5e9a = ["length_coefficient", "secondary_resistance", ""];
const $c2779 = ["start_factor", "start_time", ""];
const $c601c = [$c01d0, $cab98, $c5e9a, $c2779];
const $c361e = ["capacity", "start_time", "stop_time"];
const $cdeee = ["take_up_tension", "counterweight"];
const $c9540 = $made(Quantity, $cd20a, ["force", $cb6cf]);
const $c8c7b5 = $made(Entry, $cc442, ["entry_tension", $c9540, false, "", "", "entry_tension", ""]);
const $cdeb8 = $made(Entry, $cc442, ["exit_tension", $c9540, false, "", "", "exit_tension", ""]);
const $cf1d5 = $made(Quantity, $cd20a, ["force", null]);
const $c3b23 = $made(Entry, $cc442, ["effective_tension", $cf1d5, false, "", "", "effective_tension", ""]);
const $ca2d4 = $made(Quantity, $cd20a, ["power", null]);
const $c1585 = $made(Entry, $cc442, ["power", $ca2d4, false, "", "", "power", ""]);
const $cfaf8 = $made(Quantity, $cd20a, ["force", null]);
const $c387a = $made(ByName, $cf6b7, [$cfaf8, 200]);
const $c06e6 = $made(Entry, $cc442, ["run", $c387a, false, "", "", "run", ""]);
const $cab55 = ["first", "second", "words"];
const $cd72d = $made(Limit, $cf70d, ["number", -100.0, 100.0, false, false]);
const $ce41f = $made(Quantity, $cd20a, ["number", $cd72d]);
const $c1309 = $made(Quantity, $cd20a, ["power", null]);
const $c606c = $made(Either, $cab55, [$ce41f, $c1309, "a share like 0.5 or \"50 %\", or a power like \"300 kW\""]);
const $cd533 = $made(Rows, $ce552, [$c606c, 1, 10]);
const $c62e6 = $made(Entry, $cc442, ["share", $cd533, false, "", "", "share", ""]);
const $c4bb9 = $made(SpeedList, [], []);
const $cd0ab = $made(Entry, $cc442, ["speeds", $c4bb9, false, "", "", "speeds", ""]);
const $ce4cb = $made(Limit, $cf70d, ["number", 0.0, 1.0, false, false]);
const $c85f3 = $made(Percent, $c7fcc, ["number", $ce4cb, 1.0]);
const $c33da = $made(ByName, $cf6b7, [$c85f3, 200]);
const $c1cb8 = $made(Entry, $cc442, ["uncertainty", $c33da, false, "", "", "uncertainty", ""]);
const $cf30b = [$c8c7b5, $cdeb8, $c3b23, $c1585, $c06e6, $c62e6, $cd0ab, $c1cb8];
const $cdccd = new Map([["entry_tension", $c8c7b5], ["exit_tension", $cdeb8], ["effective_tension", $c3b23], ["power", $c1585], ["run", $c06e6], ["share", $c62e6], ["speeds", $cd0ab], ["uncertainty", $c1cb8]]);
const $c4c2c = $made(tables$Table, $c38db, [null, null, $cf30b, $cdccd]);
const $c78be = $made(Entry, $cc442, ["train", $c4c2c, false, "", "", "train", ""]);
const $c70ae = [$ceb06, $c14dd, $c8d03, $cd64e, $c7998, $c78be];
const $c13602 = new Map([["name", $ceb06], ["description", $c14dd], ["kind", $c8d03], ["condition", $cd64e], ["pulley", $c7998], ["train", $c78be]]);
const $cc28d = $made(tables$Table, $c38db, [null, $ca636, $c70ae, $c13602]);
const $cc379 = $made(Rows, $ce552, [$cc28d, 1, 1000]);
const $c7c86 = $made(Entry, $cc442, ["load_case", $cc379, false, "", "", "load_case", ""]);
const $c57f7 = $made(Limit, $cf70d, ["number", 0.0, 1.0, false, false]);
const $cb0ab = $made(Percent, $c7fcc, ["number", $c57f7, 1.0]);
const $c16ce = $made(ByName, $cf6b7, [$cb0ab, 200]);
const $c8c23 = $made(Entry, $cc442, ["uncertainty", $c16ce, false, "", "", "uncertainty", ""]);
const $c4415 = $made(Quantity, $cd20a, ["length", $cd632]);
const $c6fec = $made(Rows, $ce552, [$c4415, 1, 10]);
const $c85cb = $made(Entry, $cc442, ["diameters", $c6fec, false, "", "", "diameters", ""]);
const $ce961 = ["converter"];
const $cef58 = new Map([]);
const $cf679 = $made(Choice, $c322f, [$ce961, $cef58]);
const $c33ea = $made(Entry, $cc442, ["kind", $cf679, true, "", "", "kind", ""]);
const $c67e0 = $made(Limit, $cf70d, ["power", 0.0, 1000000000.0, true, false]);
const $c9e10 = $made(Quantity, $cd20a, ["power", $c67e0]);
const $cfb66 = $made(Entry, $cc442, ["rated_power", $c9e10, true, "", "", "rated_power", ""]);
const $cb286 = $made(Limit, $cf70d, ["rotation_speed", 0.0, 100000.0, true, false]);
const $ca54b = $made(Quantity, $cd20a, ["rotation_speed", $cb286]);
const $ca92d = $made(Entry, $cc442, ["rated_speed", $ca54b, true, "", "", "rated_speed", ""]);
const $c2a89 = $made(Limit, $cf70d, ["number", 0.0, 10000.0, true, false]);
const $c2a15 = $made(Quantity, $cd20a, ["number", $c2a89]);
const $cfdcf = $made(Entry, $cc442, ["gear_ratio", $c2a15, false, "", "", "gear_ratio", ""]);
const $ce03b = $made(Limit, $cf70d, ["number", 0.05, 1.0, false, false]);
const $c315b = $made(Quantity, $cd20a, ["number", $ce03b]);
const $c1481 = $made(Entry, $cc442, ["gear_efficiency", $c315b, false, "", "", "gear_efficiency", ""]);
const $cf04b = $made(Limit, $cf70d, ["number", 0.05, 1.0, false, false]);
const $cff58 = $made(Quantity, $cd20a, ["number", $cf04b]);
const $c7c17 = $made(Entry, $cc442, ["motor_efficiency", $cff58, false, "", "", "motor_efficiency", ""]);
const $ccc4d = $made(Count, $c38c6, [1, 8]);
const $c9761 = $made(Entry, $cc442, ["count", $ccc4d, false, "", "", "count", ""]);
const $c249a = $made(Flag, [], []);
const $ccf35 = $made(Entry, $cc442, ["brakes", $c249a, false, "", "", "brakes", ""]);
const $c44c9 = $made(Limit, $cf70d, ["number", 0.01, 3.0, false, false]);
const $c05f8 = $made(Quantity, $cd20a, ["number", $c44c9]);
const $c8590 = $made(Entry, $cc442, ["setting", $c05f8, false, "", "", "setting", ""]);
const $c79a1 = $made(Limit, $cf70d, ["number", 0.0, 0.5, false, false]);
const $c5e16 = $made(Quantity, $cd20a, ["number", $c79a1]);
const $c7dbd = $made(Entry, $cc442, ["droop", $c5e16, false, "", "", "droop", ""]);
const $c7b1d = $made(Limit, $cf70d, ["number", 0.0, Infinity, true, true]);
const $c2b95 = $made(Quantity, $cd20a, ["number", $c7b1d]);
const $c4973 = $made(WordOr, $c6a10, ["rigid", $c2b95, Infinity]);
const $cd819 = $made(Entry, $cc442, ["torque_limit", $c4973, false, "", "", "torque_limit", ""]);
const $c008b = [$c33ea, $cfb66, $ca92d, $cfdcf, $c1481, $c7c17, $c9761, $ccf35, $c8590, $c7dbd, $cd819];
const $ceb2f = new Map([["kind", $c33ea], ["rated_power", $cfb66], ["rated_speed", $ca92d], ["gear_ratio", $cfdcf], ["gear_efficiency", $c1481], ["motor_efficiency", $c7c17], ["count", $c9761], ["brakes", $ccf35], ["setting", $c8590], ["droop", $c7dbd], ["torque_limit", $cd819]]);
const $cff0a = $made(tables$Table, $c38db, [VariableSpeed, null, $c008b, $ceb2f]);
const $c552ce = ["induction"];
const $c9ea1 = new Map([]);
const $c7994 = $made(Choice, $c322f, [$c552ce, $c9ea1]);
const $ce96a = $made(Entry, $cc442, ["kind", $c7994, true, "", "", "kind", ""]);
const $c1fe6 = $made(Quantity, $cd20a, ["power", $c67e0]);
const $c8340 = $made(Entry, $cc442, ["rated_power", $c1fe6, true, "", "", "rated_power", ""]);
const $c984b = $made(Quantity, $cd20a, ["rotation_speed", $cb286]);
const $c0dee = $made(Entry, $cc442, ["rated_speed", $c984b, true, "", "", "rated_speed", ""]);
const $ce44d = $made(Quantity, $cd20a, ["number", $c2a89]);
const $cd486 = $made(Entry, $cc442, ["gear_ratio", $ce44d, false, "", "", "gear_ratio", ""]);
const $c4026 = $made(Quantity, $cd20a, ["number", $ce03b]);
const $c9c8b = $made(Entry, $cc442, ["gear_efficiency", $c4026, false, "", "", "gear_efficiency", ""]);
const $cd6bf = $made(Quantity, $cd20a, ["number", $cf04b]);
const $c5400 = $made(Entry, $cc442, ["motor_efficiency", $cd6bf, false, "", "", "motor_efficiency", ""]);
const $cf207 = $made(Flag, [], []);
const $cb3f9 = $made(Entry, $cc442, ["brakes", $cf207, false, "", "", "brakes", ""]);
const $c065a = $made(Limit, $cf70d, ["rotation_speed", 0.0, 100000.0, true, false]);
const $c04a8 = $made(Quantity, $cd20a, ["rotation_speed", $c065a]);
const $c888b = $made(Entry, $cc442, ["synchronous_speed", $c04a8, true, "", "", "synchronous_speed", ""]);
const $c8688 = $made(Limit, $cf70d, ["number", 1.1, 10.0, false, false]);
const $c9a6a = $made(Quantity, $cd20a, ["number", $c8688]);
const $c2dc3 = $made(Entry, $cc442, ["breakdown_ratio", $c9a6a, false, "", "", "breakdown_ratio", ""]);
const $c292f = [$ce96a, $c8340, $c0dee, $cd486, $c9c8b, $c5400, $c9761, $cb3f9, $c888b, $c2dc3];
const $c22d4 = new Map([["kind", $ce96a], ["rated_power", $c8340], ["rated_speed", $c0dee], ["gear_ratio", $cd486], ["gear_efficiency", $c9c8b], ["motor_efficiency", $c5400], ["count", $c9761], ["brakes", $cb3f9], ["synchronous_speed", $c888b], ["breakdown_ratio", $c2dc3]]);
const $c23bf = $made(tables$Table, $c38db, [Induction, null, $c292f, $c22d4]);
const $cb454 = ["fluid-coupling"];
const $c326a = new Map([]);
const $cc915 = $made(Choice, $c322f, [$cb454, $c326a]);
const $c2246 = $made(Entry, $cc442, ["kind", $cc915, true, "", "", "kind", ""]);
const $ce3ea = $made(Quantity, $cd20a, ["power", $c67e0]);
const $c97eb = $made(Entry, $cc442, ["rated_power", $ce3ea, true, "", "", "rated_power", ""]);
const $cbcb1 = $made(Quantity, $cd20a, ["rotation_speed", $cb286]);
const $c95d25 = $made(Entry, $cc442, ["rated_speed", $cbcb1, true, "", "", "rated_speed", ""]);
const $ca17d = $made(Quantity, $cd20a, ["number", $c2a89]);
const $cd017 = $made(Entry, $cc442, ["gear_ratio", $ca17d, false, "", "", "gear_ratio", ""]);
const $c794e = $made(Quantity, $cd20a, ["number", $ce03b]);
const $ceea5 = $made(Entry, $cc442, ["gear_efficiency", $c794e, false, "", "", "gear_efficiency", ""]);
const $cc529 = $made(Quantity, $cd20a, ["number", $cf04b]);
const $ccf84 = $made(Entry, $cc442, ["motor_efficiency", $cc529, false, "", "", "motor_efficiency", ""]);
const $cc405 = $made(Flag, [], []);
const $c7a0e = $made(Entry, $cc442, ["brakes", $cc405, false, "", "", "brakes", ""]);
const $c5889 = $made(Quantity, $cd20a, ["rotation_speed", $c065a]);
const $cf1c8 = $made(Entry, $cc442, ["synchronous_speed", $c5889, true, "", "", "synchronous_speed", ""]);
const $cde70 = $made(Quantity, $cd20a, ["number", $c8688]);
const $cff62 = $made(Entry, $cc442, ["breakdown_ratio", $cde70, false, "", "", "breakdown_ratio", ""]);
const $cb9c1 = $made(Limit, $cf70d, ["number", 0.0, 10.0, false, false]);
const $cbc2c = $made(Quantity, $cd20a, ["number", $cb9c1]);
const $cc04f = $made(Rows, $ce552, [$cbc2c, 2, 200]);
const $ce2c8 = $made(Entry, $cc442, ["coupling_load", $cc04f, true, "", "", "coupling_load", ""]);
const $c30d4 = $made(Entry, $cc442, ["coupling_slip", $cc04f, true, "", "", "coupling_slip", ""]);
const $cc970 = [$c2246, $c97eb, $c95d25, $cd017, $ceea5, $ccf84, $c9761, $c7a0e, $cf1c8, $cff62, $ce2c8, $c30d4];
const $c480a = new Map([["kind", $c2246], ["rated_power", $c97eb], ["rated_speed", $c95d25], ["gear_ratio", $cd017], ["gear_efficiency", $ceea5], ["motor_efficiency", $ccf84], ["count", $c9761], ["brakes", $c7a0e], ["synchronous_speed", $cf1c8], ["breakdown_ratio", $cff62], ["coupling_load", $ce2c8], ["coupling_slip", $c30d4]]);
const $c049a = $made(tables$Table, $c38db, [FluidCoupling, null, $cc970, $c480a]);
const $c65bf = ["follower"];
const $c695f = new Map([]);
const $cfee7 = $made(Choice, $c322f, [$c65bf, $c695f]);
const $c5659 = $made(Entry, $cc442, ["kind", $cfee7, true, "", "", "kind", ""]);
const $c0953 = $made(Name, $c4a10, [60]);
const $c0871 = $made(Entry, $cc442, ["master", $c0953, true, "", "", "master", ""]);
const $cc754 = $made(Limit, $cf70d, ["number", -10.0, 10.0, false, false]);
const $cfc94 = $made(Quantity, $cd20a, ["number", $cc754]);
const $cae8e = $made(Entry, $cc442, ["ratio", $cfc94, false, "", "", "ratio", ""]);
const $c61d0 = [$c5659, $c0871, $cae8e];
const $cea6d = new Map([["kind", $c5659], ["master", $c0871], ["ratio", $cae8e]]);
const $c73b3 = $made(tables$Table, $c38db, [TorqueFollower, null, $c61d0, $cea6d]);
const $cc5ca = new Map([["converter", $cff0a], ["induction", $c23bf], ["fluid-coupling", $c049a], ["follower", $c73b3]]);
const $ce9f3 = $made(Variant, $c3ebe, ["kind", $cc5ca]);
const $cc7b5 = $made(ByName, $cf6b7, [$ce9f3, 200]);
const $c0179 = $made(Entry, $cc442, ["motor", $cc7b5, false, "", "", "motor", ""]);
const $ca64e = [$c8c7b5, $cdeb8, $c3b23, $c1585, $c06e6, $c62e6, $cd0ab, $c8c23, $c85cb, $c0179];
const $c408e = new Map([["entry_tension", $c8c7b5], ["exit_tension", $cdeb8], ["effective_tension", $c3b23], ["power", $c1585], ["run", $c06e6], ["share", $c62e6], ["speeds", $cd0ab], ["uncertainty", $c8c23], ["diameters", $c85cb], ["motor", $c0179]]);
const $c8384 = $made(tables$Table, $c38db, [null, null, $ca64e, $c408e]);
const $cf664 = $made(Entry, $cc442, ["train", $c8384, false, "", "", "train", ""]);
const $ccce2 = [$cb73a, $c34bd, $ce3f29, $cb10e, $c750b, $cfe86, $c2dd7, $c141c, $c7c86, $c8364, $cdc1c, $c25c2, $cdb8f, $c490f, $c1441, $cf664, $cb32b, $c1e1e];
const $ca19c = new Map([["format", $cb73a], ["title", $c34bd], ["description", $ce3f29], ["creep_limit", $cb10e], ["condition", $c750b], ["belt", $cfe86], ["pulley", $c2dd7], ["lagging", $c141c], ["load_case", $c7c86], ["conveyor", $c8364], ["take_up", $cdc1c], ["design_standard", $c25c2], ["safety_factor", $cdb8f], ["sag", $c490f], ["covered", $c1441], ["train", $cf664], ["motion", $cb32b], ["learned", $c1e1e]]);
const $c8e8b = $made(tables$Table, $c38db, [Drive, null, $ccce2, $ca19c]);
const $c2c8e = ["entry_tension", "exit_tension", "effective_tension", "power", "run", "uncertainty"];
const $cc303 = new Map([["The pulley transmits its load.", true], ["Gross slip: no creep gives enough friction for this tension ratio. Raise the slack-side tension (take-up), increase the wrap angle, or choose a lagging with more friction.", false], ["The solver did not reach its accuracy on this arc. Please report the drive file; until then change a value slightly.", false], ["The drives transmit the load.", true], ["Gross slip: a drive cannot transmit its share of the load. Raise the slack-side tension (take-up), bring the speeds closer together, or choose a lagging with more friction.", false], ["No operating point: a motor would have to work outside its curve. Change its set speed or gear, or choose another motor.", false], ["The solver did not reach its accuracy on this train. Please report the drive file; until then change a value slightly.", false]]);
const $cf933 = new Map([["illustrative", "illustrative: it describes no real product"], ["calibrated", "calibrated: it was fitted to a known result"]]);
const $c5dd1 = ["illustrative", "calibrated", "estimated"];
const $c8123 = new WeakMap();
const $cd857 = ["Gross slip: one drive cannot transmit its share", "gross slip", ""];
const $c6b46 = ["Motor limit reached: no operating point", "motor limit", "Try another speed or motor."];
const $c7df9 = ["No solution", "not solved", "Do not use this result. Report the drive file."];
const $c3340 = new Map([["Gross slip: a drive cannot transmit its share of the load. Raise the slack-side tension (take-up), bring the speeds closer together, or choose a lagging with more friction.", $cd857], ["No operating point: a motor would have to work outside its curve. Change its set speed or gear, or choose another motor.", $c6b46], ["The solver did not reach its accuracy on this train. Please report the drive file; until then change a value slightly.", $c7df9]]);
const $cc967 = ["name", "what", "missed", "fails_beyond", "is_percent", "at_most", "dimension", "tension", "binding", "firm", "result", "value", "allowed", "limit", "rounded", "text", "find_checks"];
const $cb138 = $made(Rule, $cc967, ["train_balance", "the balance of the train", "INTERNAL ERROR", NaN, false, true, "number", "", false, null, "", null, null, null, null, null, null]);
const $c625f = new Map([[false, "Motor torque, running"], [true, "Motor torque, momentary"]]);
const $c58a5 = $made(Rule, $cc967, ["momentary_load", "the momentary torque of a motor", "ATTENTION", NaN, true, true, "number", "", true, null, "", of_train___motor_torque, null, null, null, null, null]);
const $c0dbc = $made(Rule, $cc967, ["motor_load", "the rating of a motor", "ATTENTION", 1.15, true, true, "number", "", true, null, "", of_train___motor_torque, null, null, null, null, null]);
const $c576d = ["Speed"];
const $c87cd = ["Motor"];
const $c84c4 = $made(Rule, $cc967, ["gross_slip", "the gross-slip safety", "ATTENTION", 1.0, false, false, "number", "raise", true, null, "", null, null, null, null, null, null]);
const $c48c7 = new Map([[0, "A creep of {slides} comes first."], [1, "The end of the tested slip of lagging ⟦lagging⟧ comes first."], [2, "The whole friction of the wrap comes first."]]);
const $cc89a = ["exit_creep", "peak_shear_stress", "largest_slip", "slip_speed"];
const $c960d = $made(Rule, $cc967, ["design_standard", "the design standard", "ATTENTION", NaN, false, false, "force", "raise", true, of_arc___binds, "", null, null, null, null, null, of_arc___standard]);
const $cc27f = $made(Rule, $cc967, ["creep", "the creep limit", "ATTENTION", 0.0635, false, true, "length", "raise", true, null, "exit_creep", null, null, of_arc___creep_limit, null, of_arc___creep, null]);
const $c8a85 = $made(Rule, $cc967, ["cover_creep", "the creep limit, with the cover of the belt in series", "ATTENTION", NaN, false, true, "length", "raise", false, null, "", null, null, null, null, null, of_arc___cover_creep]);
const $cef26 = $made(Rule, $cc967, ["creep_interval", "the creep limit, at the end of the interval of the law", "ATTENTION", NaN, false, true, "length", "raise", false, null, "", null, null, null, null, null, in_page_checks__creep_interval]);
const $c2e75 = $made(Rule, $cc967, ["wet_creep", "the creep limit when wet (estimated)", "ATTENTION", NaN, false, true, "length", "raise", false, null, "", null, null, null, null, null, of_wet___wet_creep]);
const $c8994 = $made(Rule, $cc967, ["belt_tension", "the rating of the belt", "FAILS", NaN, false, true, "force", "lower", true, null, "", of_drive___tight, of_drive___running_tension, of_drive___over_width, null, of_drive___running, null]);
const $c5c30 = $made(Rule, $cc967, ["momentary_tension", "the momentary rating of the belt", "FAILS", NaN, false, true, "force", "lower", true, null, "", of_drive___tight, of_drive___momentary_tension, of_drive___over_width, null, of_drive___momentary, null]);
const $c25bf = $made(Rule, $cc967, ["belt_safety", "the safety factor of the belt", "ATTENTION", 3.0, false, false, "number", "lower", true, of_drive___rated, "", of_drive___belt_safety, of_drive___required_safety, null, of_drive___rounded_safety, of_drive___safety, null]);
const $c72eb = $made(Rule, $cc967, ["face_pressure", "the pressure on the pulley face", "ATTENTION", NaN, false, true, "pressure", "lower", true, null, "", of_drive___tight_pressure, of_drive___face_pressure, null, null, of_drive___on_face, null]);
const $ce298 = $made(Rule, $cc967, ["bond_stress", "the bond strength of the lagging", "ATTENTION", NaN, false, true, "pressure", "", true, null, "peak_shear_stress", null, of_arc___bond_strength, null, null, of_arc___bond, null]);
const $cb3d1 = $made(Rule, $cc967, ["fatigue_stress", "the fatigue limit of the lagging", "ATTENTION", NaN, false, true, "pressure", "", true, null, "peak_shear_stress", null, of_arc___fatigue_limit, null, null, of_arc___fatigue, null]);
const $cc16f = $made(Rule, $cc967, ["tested_pressure_max", "the maximum wrap pressure tested", "ATTENTION", NaN, false, true, "pressure", "lower", true, null, "", of_drive___tight_pressure, of_drive___pressure_max, null, null, of_drive___tested_max, null]);
const $cfecd = $made(Rule, $cc967, ["tested_pressure_min", "the minimum wrap pressure tested", "ATTENTION", NaN, false, false, "pressure", "raise", true, null, "", of_drive___slack_pressure, of_drive___pressure_min, null, null, of_drive___tested_min, null]);
const $cabd6 = $made(Rule, $cc967, ["condition", "friction that was not tested in the condition", "ATTENTION", NaN, false, true, "number", "", false, null, "", null, null, null, null, null, of_data___condition]);
const $c3f6d = $made(Rule, $cc967, ["fit", "friction that does not fit its tests", "ATTENTION", NaN, false, true, "number", "", false, null, "", null, null, null, null, null, of_data___fit]);
const $c5a91 = $made(Rule, $cc967, ["tested_slip", "the maximum slip tested", "ATTENTION", NaN, false, true, "length", "raise", true, null, "largest_slip", null, of_arc___slip_max, null, null, of_arc___slip, null]);
const $c5d85 = $made(Rule, $cc967, ["tested_slip_speed", "the slip speed tested", "ATTENTION", NaN, false, true, "speed", "", false, null, "slip_speed", null, of_arc___tested_speed, null, null, of_arc___speed, null]);
const $c0d6e = $made(Rule, $cc967, ["balance", "the energy balance", "INTERNAL ERROR", NaN, false, true, "number", "", false, null, "", null, null, null, null, null, of_arc___balance]);
const $c8634 = $made(Rule, $cc967, ["sag", "the sag of the belt", "ATTENTION", NaN, false, false, "force", "raise", true, null, "", of_drive___slack_end, of_drive___sag_tension, null, null, of_drive___sag, null]);
const $cedd5 = [$c960d, $cc27f, $c8a85, $cef26, $c2e75, $c8994, $c5c30, $c25bf, $c72eb, $ce298, $cb3d1, $cc16f, $cfecd, $cabd6, $c3f6d, $c5a91, $c5d85, $c0d6e, $c8634];
const $cae1d = new Map([[228, 97], [225, 97], [224, 97], [226, 97], [227, 97], [229, 97], [233, 101], [232, 101], [234, 101], [235, 101], [237, 105], [236, 105], [238, 105], [239, 105], [246, 111], [243, 111], [242, 111], [244, 111], [245, 111], [250, 117], [249, 117], [251, 117], [252, 117], [231, 99], [241, 110]]);
const $c3b1b = ["running", "runs", "steady", "continuous", "downhill", "regenerative", "regenerating", "generating", "after", "before", "between", "no", "non", "not", "without", "released", "off", "betrieb", "nach", "vor", "ohne", "sin", "despues", "sans", "apres", "sem", "depois", "senza", "dopo"];
const $cc951 = ["start", "starts", "starting", "startup", "restart", "restarting", "acceleration", "accelerating", "anlauf", "anfahren", "anfahrt", "hochlauf", "beschleunigung", "arranque", "aceleracion", "demarrage", "partida", "aceleracao", "avviamento", "avvio", "accelerazione"];
const $cab57 = ["stop", "stops", "stopping", "estop", "brake", "brakes", "braking", "deceleration", "decelerating", "bremsen", "bremsung", "notaus", "nothalt", "verzogerung", "frenado", "parada", "desaceleracion", "freinage", "arret", "frenagem", "desaceleracao", "frenata", "frenatura", "arresto"];
const $c29fa = new Map([["starting", $cc951], ["braking", $cab57]]);
const $ca865 = $made(Rule, $cc967, ["pulley_diameter", "the minimum pulley diameter of the belt", "FAILS", NaN, false, false, "length", "", true, null, "", of_drive___diameter, of_drive___least_diameter, null, null, of_drive___bending, null]);
const $c35d3 = ["Transition", "GrippingPulley"];
const $c347b = [1.0, 2.0];
const $c7675 = [5000.0, 5000000.0];
const $c7efb = [0.0004, 0.025];
const $c2316 = [0.0004, 0.035];
const $c37c2 = [0.0004, 0.03];
const $c27e6 = [0.0015, 0.06];
const $cc3eb = [300000.0, 5000000.0];
const $c449b = [0.0015, 0.02];
const $c2abf = [0.004, 0.04];
const $c3e28 = new Map([["momentary_factor", $c347b], ["in_plane_shear_stiffness", $c7675], ["pulley_cover", $c7efb], ["carry_cover", $c2316], ["carcass", $c37c2], ["thickness", $c27e6], ["cover_shear_modulus", $cc3eb], ["cord_diameter", $c449b], ["cord_pitch", $c2abf]]);
const $c5677 = [0.2, 8.0];
const $c7e9b = new Map([["sheave_ratio", $c5677]]);
const $c74b3 = [0.1, 0.9];
const $cfae6 = [1.0, 2.5];
const $c36e1 = new Map([["friction", $c74b3], ["start_factor", $cfae6]]);
const $c2484 = [1.05, 6.0];
const $c1eef = [1.0, 4.0];
const $c2789 = new Map([["running", $c2484], ["starting", $c1eef], ["braking", $c1eef]]);
const $c068a = [0.3, 8.0];
const $c609e = [1.0, 3000.0];
const $cf2bd = [0.002, 0.05];
const $c9115 = new Map([["spacing", $c068a], ["line_mass", $c609e], ["share", $cf2bd]]);
const $ca9bc = [1.0, 9.5];
const $c2448 = [1.05, 2.5];
const $c1fd0 = [0.3, 6.0];
const $c30d6 = [0.5, 12.0];
const $cdf4e = new Map([["length_coefficient", $ca9bc], ["start_factor", $c2448], ["carry_spacing", $c1fd0], ["return_spacing", $c30d6], ["sag_limit", $cf2bd]]);
const $c0bb1 = [20.0, 20000.0];
const $cc403 = [0.01, 0.04];
const $c7f69 = [1.0, 200.0];
const $c7e32 = [0.5, 100.0];
const $c3138 = new Map([["curve_radius", $c0bb1], ["friction_factor", $cc403], ["carry_idler_mass", $c7f69], ["return_idler_mass", $c7e32], ["carry_spacing", $c1fd0], ["return_spacing", $c30d6]]);
const $c6c7f = [1.0, 15000.0];
const $c869b = [0.5, 4000.0];
const $ceec6 = [0.1, 12.0];
const $cf4a1 = [0.1, 4.0];
const $cacfd = [0.1, 30.0];
const $c3196 = [100.0, 8000.0];
const $c2b5d = [0.2, 1.2];
const $ce719 = new Map([["capacity", $c6c7f], ["material_mass", $c869b], ["material_speed", $ceec6], ["skirt_width", $cf4a1], ["acceleration_length", $cacfd], ["density", $c3196], ["belt_friction", $c2b5d], ["skirt_friction", $c2b5d]]);
const $ca0e8 = [0.1, 3.0];
const $c597e = [0.02, 0.8];
const $cec4c = [0.05, 6.3];
const $c1853 = [10.0, 20000.0];
const $c4ea5 = [0.001, 0.1];
const $c2070 = [3000.0, 300000.0];
const $caade = [0.1, 1.2];
const $c3927 = [0.3, 20000.0];
const $cb855 = [0.0017, 0.09];
const $c9579 = [0.1, 1.0];
const $c297d = [10.0, 200000.0];
const $cb38d = new Map([["diameter", $ca0e8], ["shaft_diameter", $c597e], ["wrap_angle", $cec4c], ["mass", $c1853], ["width", $cf4a1], ["thickness", $c4ea5], ["pressure", $c2070], ["friction", $caade], ["length", $c3927], ["density", $c3196], ["angle", $cb855], ["trough_coefficient", $c9579], ["force", $c297d]]);
const $cb442 = [2.0, 150.0];
const $c1c3c = [1e-06, 0.001];
const $ccd14 = [0.0001, 0.05];
const $c2a1b = [0.2, 100.0];
const $c18a1 = new Map([["temperature_range", $cb442], ["thermal_expansion", $c1c3c], ["permanent_elongation", $ccd14], ["splice_length", $c2a1b]]);
const $c64a6 = [1.0, 60.0];
const $c401a = [0.01, 0.05];
const $c4674 = new Map([["idler_friction", $c64a6], ["ky", $c401a], ["other", $c297d]]);
const $c19ff = [300000.0, 100000000.0];
const $c418f = [1e-13, 1e-10];
const $cee2a = [0.01, 1.0];
const $cc366 = new Map([["elastic_modulus", $c19ff], ["wear_coefficient", $c418f], ["belt_energy_share", $cee2a]]);
const $c9716 = [0.002, 0.5];
const $c7c50 = [0.0005, 0.06];
const $c2eba = [0.15, 1.0];
const $ce4fb = new Map([["width", $c9716], ["height", $c7c50], ["stiffening", $cf4a1], ["contact_fraction", $c2eba]]);
const $c2559 = [0.05, 200.0];
const $cace2 = new Map([["area", $c2559]]);
const $c5669 = [0.05, 1.3];
const $c85db = new Map([["factor", $c5669]]);
const $c8659 = [0.3, 500.0];
const $c5159 = new Map([["distance", $c8659]]);
const $c4b5e = [0.2, 20.0];
const $cc24b = [0.08726646259971647, 1.2217304763960306];
const $ccd85 = [0.05, 2.0];
const $cd433 = new Map([["length", $c4b5e], ["trough_angle", $cc24b], ["centre_roll", $ccd85]]);
const $c71ec = [-0.01, 0.01];
const $c837c = [-0.005, 0.005];
const $cd40e = new Map([["misalignment", $c71ec], ["deflection", $c837c]]);
const $c1064 = [1.0, 250.0];
const $c95b3 = [0.6, 1.0];
const $c9405 = [0.5, 1.0];
const $c61d8 = [0.001, 0.15];
const $ce8a9 = [0.8, 4.0];
const $c25f8 = [1.5, 5.0];
const $cd787 = new Map([["gear_ratio", $c1064], ["gear_efficiency", $c95b3], ["motor_efficiency", $c9405], ["droop", $c61d8], ["torque_limit", $ce8a9], ["breakdown_ratio", $c25f8]]);
const $cdb16 = [0.1, 5.0];
const $cca9c = new Map([["ratio", $cdb16]]);
const $ce207 = new Map([["Belt", $c3e28], ["TakeUp", $c7e9b], ["DesignStandard", $c36e1], ["SafetyFactors", $c2789], ["Sag", $c9115], ["Conveyor", $cdf4e], ["Flight", $c3138], ["LoadingPoint", $ce719], ["Local", $cb38d], ["Travel", $c18a1], ["Cema", $c4674], ["Lagging", $cc366], ["Block", $ce4fb], ["Cost", $cace2], ["ConditionFactor", $c85db], ["GrippingPulley", $c5159], ["Transition", $cd433], ["Across", $cd40e], ["Motor", $cd787], ["TorqueFollower", $cca9c]]);
const $cad03 = ["mm", "m", "cm", "in", "ft"];
const $c358b = ["kN", "N", "lbf", "kgf", "tf", "MN"];
const $ccdcc = ["kN/m", "N/m", "PIW", "N/mm", "MN/m"];
const $c0321 = ["kPa", "MPa", "Pa", "psi", "bar", "GPa"];
const $ca69a = ["m/s", "m/min", "ft/min", "km/h"];
const $c0d79 = ["deg", "rad"];
const $c3320 = ["kW", "W", "hp", "MW"];
const $cf2ed = ["t", "kg", "g"];
const $c172d = ["kg/m", "g/m", "t/m"];
const $c6e75 = ["t/h", "kg/s", "kg/h"];
const $cbfef = ["kg/m3", "t/m3", "g/cm3"];
const $c4916 = ["kg m2", "t m2", "kg cm2"];
const $c9fdd = ["kN m", "N m", "MN m"];
const $cf51b = ["s", "min", "ms", "h"];
const $c5787 = new Map([["length", $cad03], ["force", $c358b], ["force_per_width", $ccdcc], ["pressure", $c0321], ["speed", $ca69a], ["angle", $c0d79], ["power", $c3320], ["mass", $cf2ed], ["mass_per_length", $c172d], ["mass_flow", $c6e75], ["density", $cbfef], ["moment_of_inertia", $c4916], ["torque", $c9fdd], ["time", $cf51b]]);
const $ca493 = new Map([["wrap pressure at the belt rating", "diameter and belt.rating"], ["belt strength over rating", "belt.strength and belt.rating: both per width"], ["belt modulus over rating", "belt.modulus and belt.rating: both per width"], ["belt mass", "belt.mass: per length of belt"], ["motor power over required power", "rated_power of the motors, Te, belt speed"], ["material per length of belt", "capacity or material_mass of the conveyor, and belt.speed"], ["conveyor lift over length", "conveyor.lift and conveyor.length"], ["tension for sag", "idler_spacing, line_mass and share of [sag]"]]);
const $cb829 = new Place("", "", "", "", "", null);
const $cc9d1 = new Map([["shell_profile", 0.015], ["worn_depth", 0.025], ["build_up", 0.03]]);
const $c6be2 = ["rated motor power", "power"];
const $c512d = ["rated motor speed", "rotation_speed"];
const $ca7d0 = ["pulley speed over belt speed", "number"];
const $c1429 = [$c6be2, $c512d, $ca7d0];
const $cf220 = [250.0, 20000000.0];
const $cb417 = [10.0, 400.0];
const $c5df7 = [0.95, 1.05];
const $cbfa6 = [$cf220, $cb417, $c5df7];
const $c643a = ["length", 3.0, 30000.0];
const $cae2d = ["lift", -1500.0, 1500.0];
const $c5d852 = ["belt_mass", 3.0, 100.0];
const $c78e7 = ["carry_idler_mass", 2.0, 60.0];
const $c0502 = ["return_idler_mass", 0.7, 30.0];
const $c3d98 = ["material_mass", 0.5, 4000.0];
const $cd613 = ["capacity", 0.1, 15000.0];
const $c66b1 = ["friction_factor", 0.01, 0.04];
const $c2ab5 = ["secondary_resistance", 10.0, 500000.0];
const $c9550 = ["special_resistance", 10.0, 200000.0];
const $caac3 = ["start_time", 1.0, 600.0];
const $cb323 = ["stop_time", 1.0, 600.0];
const $c30c8 = ["take_up_tension", 300.0, 2000000.0];
const $c7f14 = ["counterweight", 30.0, 200000.0];
const $ce959 = [$c643a, $cae2d, $c5d852, $c78e7, $c0502, $c3d98, $cd613, $c66b1, $c2ab5, $c9550, $caac3, $cb323, $c30c8, $c7f14];
const $c660d = ["belt_mass", "carry_idler_mass", "return_idler_mass"];
const $c1de8 = $made(Limit, $cf70d, ["speed", 0.0, Infinity, true, false]);
const $c6c14 = $made(Limit, $cf70d, ["number", 0.01, 100.0, false, false]);
const $c94e7 = $made(Limit, $cf70d, ["length", 0.0, 10.0, true, false]);
const $cf1ee = $made(Limit, $cf70d, ["length", 0.0, 0.2, true, false]);
const $cc312 = new Map([["length", $c43da], ["lift", $cb699], ["belt_mass", $cd830], ["carry_idler_mass", $cd2f7], ["return_idler_mass", $caf1b], ["material_mass", $cd830], ["capacity", $c7957], ["friction_factor", $c66b2], ["length_coefficient", $c0af8], ["secondary_resistance", $c05e0], ["special_resistance", $c05e0], ["return_share", $caaf2], ["start_factor", $c6d8e], ["start_time", $c9c97], ["stop_time", $c9c97], ["take_up_tension", $ca33b], ["counterweight", $caef3], ["take_up_distance", $c592c], ["speed", $c1de8], ["sheave_ratio", $c6c14], ["carry_spacing", $cc382], ["return_spacing", $cc382], ["sag_limit", $cdf72], ["rest_friction", $cd5b3], ["width", $c94e7], ["thickness", $cf1ee]]);
const $ca926 = [0.2, 4.0];
const $c3603 = [100000.0, 1000000000.0];
const $c788a = [0.05, 15.0];
const $cfb28 = [0.15, 3.0];
const $cf8a3 = [0.17453292519943295, 4.71238898038469];
const $cd717 = [2.0943951023931953, 4.71238898038469];
const $c6630 = [0.0005, 0.061];
const $c7599 = [-0.002, 0.002];
const $c8e40 = [0.0, 0.06];
const $cba68 = [100000.0, 50000000.0];
const $c850d = [100000.0, 5000000000.0];
const $c99dc = [5000.0, 2000000.0];
const $cdf7a = [10000.0, 50000000.0];
const $cc0431 = [50000.0, 10000000.0];
const $cfa622 = [0.1, 3.0];
const $c8474 = [500.0, 10000000.0];
const $cbfa0 = [4.0, 20.0];
const $ca770 = [15.0, 1000.0];
const $c5622 = [0.0, 1600000.0];
const $cb0f8 = [250.0, 20000000.0];
const $cf359 = [1.0, 130.0];
const $c39c4 = [$ca926, $c3603, $c788a, $cfb28, $cf8a3, $cd717, $c6630, $c7599, $c8e40, $cba68, $c850d, $c99dc, $cdf7a, $cdf7a, $cc0431, $cfa622, $c8474, $cbfa0, $ca770, $c5622, $c8474, $c8474, $cb0f8, $cf359];
const $ccb55 = [500.0, 2000000.0];
const $c7257 = ["minimum tested pressure", "pressure", $ccb55];
const $cfba8 = [10000.0, 10000000.0];
const $c4161 = ["maximum tested pressure", "pressure", $cfba8];
const $c5b66 = [5e-05, 0.3];
const $c0b01 = ["maximum tested slip", "length", $c5b66];
const $c2e73 = [2e-06, 0.3];
const $cfbf0 = ["tested slip speed", "speed", $c2e73];
const $cc189 = new Map([["pressure_min", $c7257], ["pressure_max", $c4161], ["slip_max", $c0b01], ["slip_speed", $cfbf0]]);
const $cece7 = [0.03, 1.9];
const $c5944 = ["force", "mass_per_length"];
const $cb216 = ["illustrative", "untested", "estimated", "calibrated"];
const $cd058 = new Map([["shear_modulus", "G"], ["compression_modulus", "E_c"], ["in_plane_shear_stiffness", "in-plane shear stiffness"], ["modulus", "belt modulus"], ["rating", "belt rating"], ["least_pulley_diameter", "minimum pulley"]]);
const $c2aa0 = [0.0015, 0.006];
const $c02c1 = [0.003, 0.015];
const $c1f4f = [$c2aa0, $c02c1];
const $cd36e = new WeakMap();
const $c63caa = [180.0, 1.2];
const $c0098 = [200.0, 1.0];
const $cba05 = [210.0, 1.0];
const $c7643 = [220.0, 0.9];
const $cc957 = [240.0, 0.8];
const $c42e0 = [$c63caa, $c0098, $cba05, $c7643, $cc957];
const $c8440 = [180.0, 0.8];
const $c77a7 = [200.0, 0.7];
const $c2923 = [210.0, 0.7];
const $ccb4b = [220.0, 0.6];
const $c8bdf = [240.0, 0.6];
const $ce64a = [$c8440, $c77a7, $c2923, $ccb4b, $c8bdf];
const $c5f1f = new Map([["bare", $c42e0], ["lagged", $ce64a]]);
const $c9a2a = ["standard", "surface", "condition", "friction", "provenance"];
const $cd49e = [0.25, 0.25];
const $c17f0 = $made(Provenance, $c535d, ["published", "CEMA, Belt Conveyors for Bulk Materials (5th edition, table 6-8; ceramic: a later one)", "", ""]);
const $c88e7 = $made(DesignFriction, $c9a2a, ["CEMA", "bare", "", $cd49e, $c17f0]);
const $c999d = [0.35, 0.35];
const $c5f69 = $made(Provenance, $c535d, ["published", "CEMA, Belt Conveyors for Bulk Materials (5th edition, table 6-8; ceramic: a later one)", "", ""]);
const $cd062 = $made(DesignFriction, $c9a2a, ["CEMA", "rubber", "", $c999d, $c5f69]);
const $c9b38 = [0.5, 0.5];
const $cbe15 = $made(Provenance, $c535d, ["published", "CEMA, Belt Conveyors for Bulk Materials (5th edition, table 6-8; ceramic: a later one)", "", "dimpled ceramic"]);
const $c16b7 = $made(DesignFriction, $c9a2a, ["CEMA", "ceramic", "", $c9b38, $cbe15]);
const $c4611 = [0.35, 0.4];
const $c477c = $made(Provenance, $c535d, ["published", "DIN 22101 by works that follow it (edition not stated there; that of the resistances here is 2002-08)", "", ""]);
const $c1654 = $made(DesignFriction, $c9a2a, ["DIN 22101", "bare", "dry", $c4611, $c477c]);
const $ca372 = [0.1, 0.1];
const $c0934 = $made(Provenance, $c535d, ["published", "DIN 22101 by works that follow it (edition not stated there; that of the resistances here is 2002-08)", "", "single value, partly from IS 11592 and REMA"]);
const $c069c = $made(DesignFriction, $c9a2a, ["DIN 22101", "bare", "wet", $ca372, $c0934]);
const $c49b6 = [0.05, 0.1];
const $c9adb = $made(Provenance, $c535d, ["published", "DIN 22101 by works that follow it (edition not stated there; that of the resistances here is 2002-08)", "", ""]);
const $cd73e = $made(DesignFriction, $c9a2a, ["DIN 22101", "bare", "wet and dirty", $c49b6, $c9adb]);
const $c4d91 = [0.4, 0.45];
const $c60f9 = $made(Provenance, $c535d, ["published", "DIN 22101 by works that follow it (edition not stated there; that of the resistances here is 2002-08)", "", "herringbone grooves"]);
const $c8dc3 = $made(DesignFriction, $c9a2a, ["DIN 22101", "rubber", "dry", $c4d91, $c60f9]);
const $c22784 = [0.35, 0.35];
const $c3568 = $made(Provenance, $c535d, ["published", "DIN 22101 by works that follow it (edition not stated there; that of the resistances here is 2002-08)", "", "herringbone grooves; single value, partly from IS 11592 and REMA"]);
const $c465b = $made(DesignFriction, $c9a2a, ["DIN 22101", "rubber", "wet", $c22784, $c3568]);
const $cfda2 = [0.25, 0.3];
const $c76e9 = $made(Provenance, $c535d, ["published", "DIN 22101 by works that follow it (edition not stated there; that of the resistances here is 2002-08)", "", "herringbone grooves"]);
const $c4544 = $made(DesignFriction, $c9a2a, ["DIN 22101", "rubber", "wet and dirty", $cfda2, $c76e9]);
const $cc087 = [0.35, 0.4];
const $c77e2 = $made(Provenance, $c535d, ["published", "DIN 22101 by works that follow it (edition not stated there; that of the resistances here is 2002-08)", "", ""]);
const $caf0d = $made(DesignFriction, $c9a2a, ["DIN 22101", "polyurethane", "dry", $cc087, $c77e2]);
const $c2cc9 = [0.35, 0.35];
const $c81c0 = $made(Provenance, $c535d, ["published", "DIN 22101 by works that follow it (edition not stated there; that of the resistances here is 2002-08)", "", "single value, partly from IS 11592 and REMA"]);
const $c33d6 = $made(DesignFriction, $c9a2a, ["DIN 22101", "polyurethane", "wet", $c2cc9, $c81c0]);
const $c46cd = [0.2, 0.2];
const $c20705 = $made(Provenance, $c535d, ["published", "DIN 22101 by works that follow it (edition not stated there; that of the resistances here is 2002-08)", "", "single value, partly from IS 11592 and REMA"]);
const $c4015 = $made(DesignFriction, $c9a2a, ["DIN 22101", "polyurethane", "wet and dirty", $c46cd, $c20705]);
const $cf072 = [0.4, 0.45];
const $c269e = $made(Provenance, $c535d, ["published", "DIN 22101 by works that follow it (edition not stated there; that of the resistances here is 2002-08)", "", ""]);
const $c762e = $made(DesignFriction, $c9a2a, ["DIN 22101", "ceramic", "dry", $cf072, $c269e]);
const $c3458 = [0.35, 0.4];
const $ce9fa = $made(Provenance, $c535d, ["published", "DIN 22101 by works that follow it (edition not stated there; that of the resistances here is 2002-08)", "", ""]);
const $c2a06 = $made(DesignFriction, $c9a2a, ["DIN 22101", "ceramic", "wet", $c3458, $ce9fa]);
const $c2dad = [0.35, 0.35];
const $cc356 = $made(Provenance, $c535d, ["published", "DIN 22101 by works that follow it (edition not stated there; that of the resistances here is 2002-08)", "", "single value, partly from IS 11592 and REMA"]);
const $c4014 = $made(DesignFriction, $c9a2a, ["DIN 22101", "ceramic", "wet and dirty", $c2dad, $cc356]);
const $c99d3 = [0.35, 0.35];
const $cb0d4 = $made(Provenance, $c535d, ["published", "Practitioners' values for a running drive, bulk-online forum", "2005", "diamond rubber"]);
const $c68bd = $made(DesignFriction, $c9a2a, ["practice", "rubber", "dry", $c99d3, $cb0d4]);
const $c69fe = [0.35, 0.35];
const $c5157 = $made(Provenance, $c535d, ["published", "Practitioners' values for a running drive, bulk-online forum", "2005", "diamond rubber"]);
const $cf0f2 = $made(DesignFriction, $c9a2a, ["practice", "rubber", "wet", $c69fe, $c5157]);
const $c9758 = [0.3, 0.3];
const $c1548 = $made(Provenance, $c535d, ["published", "Practitioners' values for a running drive, bulk-online forum", "2005", "diamond rubber"]);
const $ca0d7 = $made(DesignFriction, $c9a2a, ["practice", "rubber", "wet and dirty", $c9758, $c1548]);
const $ced9b = [0.8, 0.8];
const $c8b0a = $made(Provenance, $c535d, ["published", "Practitioners' values for a running drive, bulk-online forum", "2005", "ceramic in rubber"]);
const $cb79a = $made(DesignFriction, $c9a2a, ["practice", "ceramic", "dry", $ced9b, $c8b0a]);
const $cc49e = [0.45, 0.45];
const $cd4c0d = $made(Provenance, $c535d, ["published", "Practitioners' values for a running drive, bulk-online forum", "2005", "ceramic in rubber"]);
const $c0e8c = $made(DesignFriction, $c9a2a, ["practice", "ceramic", "wet", $cc49e, $cd4c0d]);
const $c384c = [0.35, 0.35];
const $c15e3 = $made(Provenance, $c535d, ["published", "Practitioners' values for a running drive, bulk-online forum", "2005", "ceramic in rubber"]);
const $c8b09 = $made(DesignFriction, $c9a2a, ["practice", "ceramic", "wet and dirty", $c384c, $c15e3]);
const $c9375 = [$c88e7, $cd062, $c16b7, $c1654, $c069c, $cd73e, $c8dc3, $c465b, $c4544, $caf0d, $c33d6, $c4015, $c762e, $c2a06, $c4014, $c68bd, $cf0f2, $ca0d7, $cb79a, $c0e8c, $c8b09];
const $c13e8 = $made(Rule, $cc967, ["belt_thickness", "a trim without the thickness of the belt", "ATTENTION", NaN, false, true, "number", "", false, null, "", null, null, null, null, null, null]);
const $c75f4 = $made(Rule, $cc967, ["taut", "a belt that nowhere hangs slack", "ATTENTION", NaN, false, false, "number", "", true, null, "", null, null, null, null, null, null]);
const $c9629 = $made(Rule, $cc967, ["usual_sizes", "an implausible input", "ATTENTION", NaN, false, true, "number", "", false, null, "", null, null, null, null, null, null]);
const $c629d = $made(Rule, $cc967, ["case_kind", "the kind of a load case", "ATTENTION", NaN, false, true, "number", "", false, null, "", null, null, null, null, null, null]);
const $c376b = $made(Rule, $cc967, ["motor_heat", "the heating limit of a motor", "ATTENTION", NaN, false, true, "time", "", true, null, "", null, null, null, null, null, null]);
const $c1dc5 = new Map([["belt_thickness", $c13e8], ["gross_slip", $c84c4], ["design_standard", $c960d], ["creep", $cc27f], ["cover_creep", $c8a85], ["creep_interval", $cef26], ["wet_creep", $c2e75], ["belt_tension", $c8994], ["momentary_tension", $c5c30], ["belt_safety", $c25bf], ["face_pressure", $c72eb], ["bond_stress", $ce298], ["fatigue_stress", $cb3d1], ["tested_pressure_max", $cc16f], ["tested_pressure_min", $cfecd], ["condition", $cabd6], ["fit", $c3f6d], ["tested_slip", $c5a91], ["tested_slip_speed", $c5d85], ["balance", $c0d6e], ["sag", $c8634], ["taut", $c75f4], ["pulley_diameter", $ca865], ["usual_sizes", $c9629], ["case_kind", $c629d], ["motor_load", $c0dbc], ["momentary_load", $c58a5], ["motor_heat", $c376b], ["train_balance", $cb138]]);
const $c80d9 = ["Value", "Limit", "Used", "Status"];
const $c9028 = new Map([["distributed", "distributed"], ["paper", "paper's integration"]]);
const $c450e = new WeakMap();
const $ce893 = ["short", "arcs", "tiles", "compare"];
const $c80d8 = new KeyFigure("entry_tension", "", $ce893);
const $c357c = new KeyFigure("exit_tension", "", $ce893);
const $c025a = new KeyFigure("effective_tension", "", $ce893);
const $cfc1b = ["short", "arcs", "drives", "compare", "changes"];
const $c6e16 = new KeyFigure("tension_ratio", "", $cfc1b);
const $cde27 = ["short", "arcs"];
const $c614b = new KeyFigure("exit_creep", "low", $cde27);
const $c7619 = ["short", "drives", "compare"];
const $ce6ba = new KeyFigure("exit_slip", "", $c7619);
const $c5a50 = ["tiles"];
const $c9acc = new KeyFigure("peak_shear_stress", "low", $c5a50);
const $ced8c = ["short", "drives"];
const $c3595 = new KeyFigure("peak_shear_angle", "low", $ced8c);
const $c100f = ["short", "drives", "compare", "changes"];
const $cfd95 = new KeyFigure("mean_friction", "", $c100f);
const $cf709 = ["short", "changes"];
const $c682b = new KeyFigure("creep_limit_margin", "high", $cf709);
const $cf438 = new KeyFigure("equivalent_friction", "", $c7619);
const $cf343 = new KeyFigure("power_loss", "low", []);
const $c3b87 = [$c80d8, $c357c, $c025a, $c6e16, $c614b, $ce6ba, $c9acc, $c3595, $cfd95, $c682b, $cf438, $cf343];
const $c4e7c = ["entry_tension", "exit_tension", "effective_tension", "tension_ratio", "exit_creep", "exit_slip", "peak_shear_stress", "peak_shear_angle", "mean_friction", "active_arc", "k_factor", "stuck_arc", "outside_tested_share", "creep_limit_capacity", "creep_limit_margin", "equivalent_friction", "tested_slip_capacity", "gross_slip_capacity", "transmitted_power", "sliding_power", "shear_loss", "power_loss", "efficiency", "frictional_energy", "wear_rate"];
const $c3f74 = ["name", "surface", "material", "life_years", "provenance"];
const $c37a3 = [1, 2];
const $cba33 = $made(Provenance, $c535d, ["published", "Elastotec, lagging comparison, elastotec.com.au/lagging-comparison", "", "life of ceramic: over 10 years; the vendor's own assumptions; currency not stated there, AUD assumed"]);
const $c3f83 = $made(LaggingCost, $c3f74, ["rubber", "rubber", 625, $c37a3, $cba33]);
const $c9cd5 = [10, 10];
const $c3221 = $made(Provenance, $c535d, ["published", "Elastotec, lagging comparison, elastotec.com.au/lagging-comparison", "", "life of ceramic: over 10 years; the vendor's own assumptions; currency not stated there, AUD assumed"]);
const $cf10e = $made(LaggingCost, $c3f74, ["ceramic, cold bonded", "ceramic", 4600, $c9cd5, $c3221]);
const $ca54f = [10, 10];
const $c6e63 = $made(Provenance, $c535d, ["published", "Elastotec, lagging comparison, elastotec.com.au/lagging-comparison", "", "life of ceramic: over 10 years; the vendor's own assumptions; currency not stated there, AUD assumed"]);
const $ce13a = $made(LaggingCost, $c3f74, ["ceramic, hot vulcanised", "ceramic", 4950, $ca54f, $c6e63]);
const $c2342 = [$c3f83, $cf10e, $ce13a];
const $c97d8 = new ModulusRatio(1.6, 2.0, "permanent and elastic elongation at the rating of 16 fabric belts (Goodyear EP conveyor belt catalogue, 2012, p. 15 and 21)");
const $ccd79 = new ModulusRatio(1.5, 2.2, "permanent elongation of 0.1 to 0.25 % (conveyorbeltguide.com, Testing), elastic elongation at the rating (Goodyear EP conveyor belt catalogue, 2012)");
const $c8e29 = new Map([["fabric", $c97d8], ["steel cord", $ccd79]]);
const $c838e = $made(Provenance, $c535d, ["given", "", "", "estimated: belt covers have 0.8 to 1.5 MPa (116 to 218 psi)"]);
const $c7015 = $made(Provenance, $c535d, ["given", "", "", ""]);
const $c7515 = $made(Provenance, $c535d, ["published", "B. DeVries, A model of lagging friction as a function of creep history and wrap pressure", "", "the conservative customary limit"]);
const $cac76 = new Map([["entry_tension", "T1"], ["exit_tension", "T2"]]);
const $c2862 = $re("\\.?([A-Za-z_][A-Za-z0-9_-]*)|\\[(\\d+)\\]", "");
const $c246c = ["format", "name", "title", "description", "surface", "thickness", "elastic_modulus", "shear_modulus", "compression_modulus", "block", "wear_coefficient", "belt_energy_share", "bond_strength", "fatigue_limit", "cost", "slip_speed", "temperature", "condition_factor", "law", "uncertainty", "provenance", "sources", "notes"];
const $c6dce = ["name", "title", "surface", "elastic_modulus", "wear_coefficient", "belt_energy_share", "bond_strength", "fatigue_limit", "description"];
const $c5832 = ["friction", "slip", "thickness", "shear_modulus", "compression_modulus"];
const $c65ce = ["elastic_modulus", "shear_modulus", "compression_modulus", "block"];
const $c9095 = ["thickness", "shear_modulus", "compression_modulus"];
const $cd06c = new Map([["width", $c318b], ["height", $cd6edf], ["stiffening", $caba4], ["contact_fraction", $cbc3c]]);
const $cf9e0 = new Map([["friction_coefficient", "friction"], ["slip_max", "tested_slip"], ["tested", "tested_pressure"], ["pieces.a", "A"], ["values", "rows"], ["peak_friction", "knots"], ["peak_slip", "knots"], ["post_peak_slope", "knots"], ["residual_friction", "knots"]]);
const $c2f5d = new Map([["integral-log", "knots"], ["table", "rows"]]);
const $cfe34 = $re("\\s*(?<sign>[+-])?\\s*(?<number>(?:[0-9]+(?:\\.[0-9]*)?|\\.[0-9]+)(?:[eE][+-]?[0-9]{1,3})?)?\\s*\\*?\\s*(?<factor>p(?:\\s*\\^\\s*(?:\\(\\s*(?<within>[+-]?(?:[0-9]+(?:\\.[0-9]*)?|\\.[0-9]+)(?:[eE][+-]?[0-9]{1,3})?)\\s*\\)|(?<power>[+-]?(?:[0-9]+(?:\\.[0-9]*)?|\\.[0-9]+)(?:[eE][+-]?[0-9]{1,3})?)))?|ln\\(\\s*p\\s*\\)(?:\\s*\\^\\s*(?<log_power>[123]))?|exp\\((?<exponent>(?:[^()]|\\(\\s*p\\s*\\))*)\\))?\\s*", "");
const $c5f05e = $made(Name, $c4a10, [60]);
const $cb374 = $made(Entry, $cc442, ["name", $c5f05e, true, "", "name = \"my-lagging\"", "name", ""]);
const $c390e5 = $made(Quantity, $cd20a, ["length", $c3f61]);
const $c98a2 = $made(Entry, $cc442, ["thickness", $c390e5, false, "", "", "thickness", ""]);
const $cb3db = $made(Quantity, $cd20a, ["pressure", $cc7a6]);
const $c6b4d = $made(Entry, $cc442, ["elastic_modulus", $cb3db, false, "", "", "elastic_modulus", ""]);
const $c0f0b = $made(Quantity, $cd20a, ["pressure", $c8b29]);
const $c86e6 = $made(WordOr, $c6a10, ["rigid", $c0f0b, Infinity]);
const $ce5e5 = $made(Entry, $cc442, ["shear_modulus", $c86e6, false, "", "", "shear_modulus", ""]);
const $c6601 = $made(Quantity, $cd20a, ["pressure", $cc576]);
const $c722b = $made(WordOr, $c6a10, ["rigid", $c6601, Infinity]);
const $c8c8d = $made(Entry, $cc442, ["compression_modulus", $c722b, false, "", "", "compression_modulus", ""]);
const $cd763 = $made(Quantity, $cd20a, ["wear_coefficient", $c7180]);
const $cb25b = $made(Entry, $cc442, ["wear_coefficient", $cd763, false, "", "", "wear_coefficient", ""]);
const $c7f3e = $made(Quantity, $cd20a, ["number", $c36e6]);
const $c9e46 = $made(Entry, $cc442, ["belt_energy_share", $c7f3e, false, "", "", "belt_energy_share", ""]);
const $c18fd = $made(Quantity, $cd20a, ["pressure", $c95d2]);
const $c3531 = $made(Entry, $cc442, ["bond_strength", $c18fd, false, "", "", "bond_strength", ""]);
const $cdb8f1 = $made(Quantity, $cd20a, ["pressure", $cc04b]);
const $c9aeb = $made(Entry, $cc442, ["fatigue_limit", $cdb8f1, false, "", "", "fatigue_limit", ""]);
const $cc3b8 = [$cb73a, $cb374, $cd66f, $cc3a1, $c5462, $c98a2, $c6b4d, $ce5e5, $c8c8d, $c29e5, $cb25b, $c9e46, $c3531, $c9aeb, $c03097, $c2480, $c2fb3, $c7315, $c8818, $c5c71, $c69c3, $c9b00, $c0a9d];
const $cec4e = new Map([["format", $cb73a], ["name", $cb374], ["title", $cd66f], ["description", $cc3a1], ["surface", $c5462], ["thickness", $c98a2], ["elastic_modulus", $c6b4d], ["shear_modulus", $ce5e5], ["compression_modulus", $c8c8d], ["block", $c29e5], ["wear_coefficient", $cb25b], ["belt_energy_share", $c9e46], ["bond_strength", $c3531], ["fatigue_limit", $c9aeb], ["cost", $c03097], ["slip_speed", $c2480], ["temperature", $c2fb3], ["condition_factor", $c7315], ["law", $c8818], ["uncertainty", $c5c71], ["provenance", $c69c3], ["sources", $c9b00], ["notes", $c0a9d]]);
const $c904b = $made(tables$Table, $c38db, [Lagging, null, $cc3b8, $cec4e]);
const $c2a62 = ["belt", "train", "conveyor", "motion"];
const $c7a99 = new FileKind("a drive file", "solve", $c2a62);
const $c6c94 = ["candidates"];
const $ccd15 = new FileKind("a choose file", "choose", $c6c94);
const $c32d2 = ["axis", "sampling"];
const $cb0c8 = new FileKind("a study file", "study", $c32d2);
const $cea33 = ["rig", "test", "digitised"];
const $c6274 = new FileKind("a test plan", "fit", $cea33);
const $c2c05d = ["number", "record", "prior", "zero"];
const $c90d1 = new FileKind("a calibrate file", "calibrate", $c2c05d);
const $c1be6 = ["belt_speed", "files", "event"];
const $cf576 = new FileKind("a learn file", "learn", $c1be6);
const $c19c3 = ["law"];
const $cb4d8 = new FileKind("a lagging file", "lagging", $c19c3);
const $c0407 = new Map([["drive", $c7a99], ["choose", $ccd15], ["study", $cb0c8], ["plan", $c6274], ["calibrate", $c90d1], ["learn", $cf576], ["lagging", $cb4d8]]);
const $cb919 = ["compression_modulus", "block", "replaced_block"];
const $c3e4a = [$cb919];
const $c31a8 = new Set(["belt_energy_share", "block", "bond_strength", "compression_modulus", "condition_factor", "cost", "elastic_modulus", "fatigue_limit", "law", "shear_modulus", "slip_speed", "temperature", "thickness", "uncertainty", "wear_coefficient"]);
const $ca1a4 = new RunsGain(0.0, 0.0);
const $cde36 = $made(Provenance, $c535d, ["given", "", "", "belt_mass of [conveyor]"]);
const $cf273 = ["effective_tension", "torque", "power"];
const $c3ab3 = ["share", "speeds", "motor"];
const $c6b61 = new Growth(1.0, 0.0);
const $cfc62 = ["data", "sense"];
const $c7ecb = new Map([["NOT CHECKED", 0], ["OK", 1], ["ATTENTION", 2], ["FAILS", 3], ["INTERNAL ERROR", 4]]);
const $c76d1 = new Map([["balance", 0.0], ["train_balance", 0.0], ["across_balance", 0.0], ["gross_slip", 1.0], ["operating_point", 1.0], ["slack_edge", 1.0], ["opposing_drives", 2.0], ["run", 2.0], ["vibration", 2.0], ["belt_tension", 3.0], ["momentary_tension", 3.0], ["belt_safety", 3.0], ["face_pressure", 3.0], ["pulley_diameter", 3.0], ["edge_tension", 3.0], ["static_edge_tension", 3.0], ["static_centre_tension", 3.0], ["transition_length", 3.0], ["uneven_face_pressure", 3.0], ["crown", 3.0], ["sag", 3.0], ["taut", 3.0], ["motor_load", 3.0], ["momentary_load", 3.0], ["motor_heat", 3.0], ["bond_stress", 4.0], ["fatigue_stress", 4.0], ["uneven_bond_stress", 4.0], ["uneven_fatigue_stress", 4.0], ["creep", 5.0], ["uneven_creep", 5.0], ["design_standard", 6.0], ["tested_slip", 7.0], ["tested_slip_speed", 7.0], ["tested_pressure_max", 7.0], ["tested_pressure_min", 7.0], ["uneven_pressure", 7.0], ["creep_interval", 8.0], ["cover_creep", 8.0], ["wet_creep", 9.0], ["condition", 10.0], ["fit", 10.0], ["belt_thickness", 10.0], ["take_up", 10.0], ["meeting", 10.0], ["case_kind", 10.0], ["uneven_wear", 10.0], ["usual_sizes", 11.0], ["profile_extent", 11.0], ["reserve", 12.0]]);
const $cda4c = ["gross_slip", "design_standard", "belt_tension", "momentary_tension", "belt_safety"];
const $ca735 = ["illustrative", "untested", "estimated", "calibrated"];
const $ce5b4 = $Decimal.of("0");
const $c0555 = [""];
const $c2a6c = ["form", "coefficients", "sign"];
const $ce094 = [0.0];
const $c07bd = $made(Trend, $c2a6c, ["polynomial", $ce094, 1]);
const $cc2ec = [1000000000.0];
const $c07bd5 = $made(Trend, $c2a6c, ["polynomial", $cc2ec, 1]);
const $c6e1f = new Map([["factor", $cd2d2]]);
const $c25b9 = new Map([["x", $c9b84], ["y", $c9b84], ["diameter", $c3de9]]);
const $cb278 = $made(Limit, $cf70d, ["force", 0.1, 1000000000.0, false, false]);
const $cf120 = new Map([["entry", $cb6cf], ["exit", $cb278]]);
const $ca880 = new Map([["position", $ccabe], ["brake_share", $c6ee3]]);
const $cd5c6 = new Map([["creep_limit", $c2680]]);
const $cd5c69 = new Map([["creep_limit", $c2680]]);
const $ce600 = new Map([["entry_tension", $cb6cf], ["exit_tension", $cb278]]);
const $c51f1 = $made(Limit, $cf70d, ["number", 1, 8, false, false]);
const $c33f2 = new Map([["rated_power", $c67e0], ["rated_speed", $cb286], ["gear_ratio", $c2a89], ["gear_efficiency", $ce03b], ["motor_efficiency", $cf04b], ["count", $c51f1]]);
const $ca384 = new Map([["rated_power", $c67e0], ["rated_speed", $cb286], ["gear_ratio", $c2a89], ["gear_efficiency", $ce03b], ["motor_efficiency", $cf04b], ["count", $c51f1], ["setting", $c44c9], ["droop", $c79a1], ["torque_limit", $c7b1d]]);
const $c98ae = new Map([["thickness", $c3f61], ["shear_modulus", $c8b29], ["compression_modulus", $cc576], ["elastic_modulus", $cc7a6], ["wear_coefficient", $c7180], ["belt_energy_share", $c36e6], ["bond_strength", $c95d2], ["fatigue_limit", $cc04b]]);
const $c2d26 = new Map([["ratio", $cc754]]);
const $c3530 = new Map([["sheave_ratio", $cf433]]);
const $ce0a3 = new Map([["friction", $c724b], ["start_factor", $c83ab]]);
const $cc53c = new Map([["running", $c83ab], ["starting", $c83ab], ["braking", $c83ab]]);
const $c2839 = ["of"];
const $c813f = ["key", "kind", "required", "example", "attribute"];
const $cb1e2 = ["dimension", "least", "most"];
const $c0b27 = ["kind"];
const $c982d = ["text"];
const $c93f2 = ["name", "what", "missed", "is_percent", "at_most", "dimension", "tension", "binding", "firm", "value", "limit", "text"];
const $c2c2b = new Map([["steel cord", 1600000.0], ["fabric", 140000.0]]);
const $ca5fa = new Map([["steel cord", 6.666666666666667], ["fabric", 8.0]]);
const $cf41d = ["name", "what", "missed", "is_percent", "at_most", "dimension", "tension", "binding", "firm", "result", "value", "limit", "text"];
const $c7c4c = ["balance", "train_balance", "across_balance"];
const $ccbad = [false, false];
const $c3044 = [true, false];
const $c7703 = [true, true];
const $c9475 = [false, true];
const $c7f7c = new Map([["polynomial", $ccbad], ["logarithmic", $c3044], ["power", $c7703], ["exponential", $c9475]]);
const $c843e = $made(_OfClass, [], []);
const $ca8ba = new Map([[10, null], [9, null]]);
const $cdade = ["1", "0.1", "0.01", "0.001", "10"];
const $c8c06 = $re("(.+?)%\\s*(?:at|@|bei|a|à|/)\\s*(.+?)%(?:.*strength)?", "i");
const $c9234 = $re("(?:ST[ -]?|(?:\\b(?:EP|EE|NN|PN|NP|PP|EB)[ -]?|^)(?=\\d+/\\d))(\\d{3,5})\\b", "");
const $c992e = [80.0, 1.92];
const $c3a02 = [90.0, 1.86];
const $c1038 = [100.0, 1.78];
const $cbcd2 = [120.0, 1.7];
const $c006c = [140.0, 1.63];
const $ce3cb = [160.0, 1.56];
const $c5cce = [180.0, 1.5];
const $cb969 = [200.0, 1.45];
const $c6d8dc = [250.0, 1.38];
const $c7781 = [300.0, 1.31];
const $c7f11 = [350.0, 1.27];
const $c60b9 = [400.0, 1.25];
const $c509f = [450.0, 1.22];
const $c58f0 = [500.0, 1.2];
const $cd0c9 = [550.0, 1.18];
const $cfa11 = [600.0, 1.17];
const $cb861 = [700.0, 1.14];
const $c55cd = [800.0, 1.12];
const $cf10c = [900.0, 1.1];
const $cd2d7 = [1000.0, 1.09];
const $cd984 = [1500.0, 1.06];
const $c7865 = [2000.0, 1.05];
const $c2838 = [$c992e, $c3a02, $c1038, $cbcd2, $c006c, $ce3cb, $c5cce, $cb969, $c6d8dc, $c7781, $c7f11, $c60b9, $c509f, $c58f0, $cd0c9, $cfa11, $cb861, $c55cd, $cf10c, $cd2d7, $cd984, $c7865];
const $c695b = ["full", "empty", "inclines", "declines", "start", "stop"];
const $c28af = ["all", "none", "inclines", "declines"];
const $cf0a0 = ["carry", "return"];
const $c98c4 = new Map([["loading", "ISO 5048:1989; DIN 22101:2002-08, 6.3.2: I_m (v - v0), and the skirts beside it"], ["wrap", "ISO 5048:1989: 9 B (140 + 0.01 F/B) d/D of fabric belts, 12 B (200 + 0.01 F/B) d/D of steel-cord belts"], ["bearing", "ISO 5048:1989: 0.005 F_T d0/D, at pulleys that are not driven"], ["cleaner", "ISO 5048:1989: A p mu3"], ["skirt", "ISO 5048:1989: mu2 I_V^2 rho g l/(v^2 b1^2)"], ["tilt", "ISO 5048:1989: C_eps mu0 L (m'G + m'L) g cos delta sin eps"], ["special", "given"], ["slope", "DIN 22101:2002-08, 6.4: g H (m'G + m'L), up on one strand and down on the other"], ["inertia", "force to accelerate belt, material and rotating idlers (DIN 22101:2002-08, 7.3), the idlers with their whole rotating mass"]]);
const $c5046 = ["main", "secondary", "loading", "wrap", "bearing", "cleaner", "slope", "special", "skirt", "tilt", "inertia"];
const $cab60 = ["loading", "wrap", "bearing", "cleaner", "skirt", "tilt"];
const $caac6 = $made(Limit, $cf70d, ["number", 0.0, Infinity, false, false]);
const $cbd59 = $made(Limit, $cf70d, ["number", 1.0, Infinity, false, false]);
const $c9bd3 = new Map([["residual_noise", $caac6], ["coverage_factor", $cbd59]]);
const $c29b0 = $re("knots\\[([0-9]{1,4})\\]\\.(peak_slip|peak_friction)", "");
const $ce5b4b = $Decimal.of("0");
const $cf7bc = new Map([["misalignment", $cbde1], ["deflection", $c94dd]]);
const $c7ba7 = new Map([["diameter", $cd632], ["wrap_angle", $c1cfe], ["overrun", $cd18d], ["creep_limit", $c2680], ["mass", $c7194]]);
const $c2d0e = new Map([["spacing", $c8124], ["line_mass", $ce5b8], ["share", $c38da]]);
const $c1fb5 = new Map([["length", $caa2d], ["lift", $c4521], ["slope", $caf42], ["curve_radius", $c60fa], ["friction_factor", $c2c94], ["carry_idler_mass", $ce405], ["return_idler_mass", $ce405], ["carry_spacing", $c3412], ["return_spacing", $c3412]]);
const $cf8c9 = new Map([["position", $ccabe], ["capacity", $c4b8f], ["material_mass", $c642a], ["material_speed", $ca1af], ["skirt_width", $c6dc5], ["acceleration_length", $c3412], ["belt_friction", $c3f2d], ["skirt_friction", $c3f2d], ["density", $c57f6]]);
const $c01b1 = new Map([["temperature_range", $c2cb0], ["thermal_expansion", $c4064], ["permanent_elongation", $c56d0], ["splice_length", $c5ca8]]);
const $cdc48 = new Map([["idler_friction", $c229c], ["temperature_factor", $c0173], ["ky", $c2c05], ["other", $c734c]]);
const $c75fc = new Map([["material", $c78fc], ["installation", $c92d0], ["area", $c0c54]]);
const $c6657 = $made(Limit, $cf70d, ["number", 0.0, 10.0, true, false]);
const $c6e1f0 = new Map([["factor", $c6657]]);
const $c19bc = new Map([["rated_power", $c67e0], ["rated_speed", $cb286], ["gear_ratio", $c2a89], ["gear_efficiency", $ce03b], ["motor_efficiency", $cf04b], ["count", $c51f1], ["synchronous_speed", $c065a], ["breakdown_ratio", $c8688]]);
const $c56ea = new Map([["length", $c96f8], ["trough_angle", $cd50c], ["centre_roll", $c3fe0]]);
const $c0a0b = new Map([["angle", $c4a8c], ["trough_coefficient", $c18d0], ["friction", $ca38a], ["length", $cd945]]);
const $ccbd6 = new Map([["position", $cd0e7], ["diameter", $c874c], ["shaft_diameter", $c444b], ["wrap_angle", $ca8c9], ["mass", $ce3fa9]]);
const $c5706 = new Map([["position", $cd0e7], ["force", $cd303]]);
const $c71085 = new Map([["position", $cd0e7], ["length", $cb596], ["width", $c874c], ["density", $cf674], ["friction", $ca38a]]);
const $c80b6 = new Map([["position", $cd0e7], ["width", $c874c], ["thickness", $c874c], ["pressure", $c9a3e], ["friction", $ca38a]]);
const $c1790 = ["dimension", "within"];
const $cdba3 = ["words"];
const $c32fc = [0.016, 0.03];
const $cfa4c = new Map([["distance", $c29d2]]);
const $ceb01 = $made(Name, $c4a10, [60]);
const $c3d72 = $made(Rows, $ce552, [$ceb01, 0, 100]);
const $cf701 = $made(Limit, $cf70d, ["number", 0.0, 10.0, true, false]);
const $c7f0e = $made(Quantity, $cd20a, ["number", $cf701]);
const $c7fde = $made(Limit, $cf70d, ["rotation_speed", 0.0, Infinity, true, false]);
const $c3520 = $made(Quantity, $cd20a, ["rotation_speed", $c7fde]);
const $c87f2 = $made(Either, $cab55, [$c7f0e, $c3520, "a trim like \"99.7 %\" or a pulley speed like \"71.6 rpm\""]);
const $cd950 = $made(Rows, $ce552, [$c87f2, 1, 10]);
Problem.$compared = Problem.$names;
$sig(InputError, ["problems"], false);
$sig(Report, ["file"], false);
$sig(Report.prototype.add, ["place", "message", "remedy", "value", "code", "meant"], false);
$sig(Record, ["values", "place", "raw", "faulty"], false);
Provenance.$compared = Provenance.$names;
$sig(_UnitTextError, ["message", "remedy", "name", "meant"], false);
Unit.$compared = Unit.$names;
BeltName.$compared = BeltName.$names;
CatalogueBelt.$compared = CatalogueBelt.$names;
$sig(Laggings, ["own", "folder", "allow_paths", "report"], false);
Condition.$compared = Condition.$names;
Condition.LIMITS = Condition.prototype.LIMITS = $c6e1f;
Conditions.$compared = Conditions.$names;
Point.$compared = Point.$names;
Point.LIMITS = Point.prototype.LIMITS = $c25b9;
UnitRow.$compared = UnitRow.$names;
WidthProfile.$compared = WidthProfile.$names;
Criteria.$compared = Criteria.$names;
Layers.$compared = Layers.$names;
Given.$compared = Given.$names;
$sig(Given.prototype.overridden, ["record", "fixed", "speed", "runs"], false);
NipTensions.$compared = NipTensions.$names;
Tensions.$compared = ["entry", "exit"];
Tensions.LIMITS = Tensions.prototype.LIMITS = $cf120;
LoadCase.$compared = LoadCase.$names;
DrivePlace.$compared = DrivePlace.$names;
DrivePlace.LIMITS = DrivePlace.prototype.LIMITS = $ca880;
Drive.$compared = ["title", "belt", "pulleys", "load_cases", "creep_limit", "criteria", "description"];
Drive.LIMITS = Drive.prototype.LIMITS = $cd5c6;
Train.$compared = ["title", "description", "belt", "pulleys", "cases", "nominal_diameters", "creep_limit", "criteria"];
Train.LIMITS = Train.prototype.LIMITS = $cd5c69;
$sig(Reader, ["record", "belt", "pulleys", "report", "take_up"], false);
Shares.$compared = Shares.$names;
TrainCase.$compared = TrainCase.$names;
TrainCase.LIMITS = TrainCase.prototype.LIMITS = $ce600;
WrapArc.$compared = WrapArc.$names;
$sig(WrapArc.on, ["belt", "pulley", "lagging"], true);
in_page$Given.$compared = in_page$Given.$names;
Rise.$compared = Rise.$names;
in_page$Criteria.$compared = in_page$Criteria.$names;
Place.$compared = Place.$names;
Motors.$compared = Motors.$names;
Motor.$compared = Motor.$names;
Motor.LIMITS = Motor.prototype.LIMITS = $c33f2;
Beyond.$compared = Beyond.$names;
Check.$compared = Check.$names;
Pulls.$compared = Pulls.$names;
Amount.$compared = Amount.$names;
CheckText.$compared = CheckText.$names;
Owner.$compared = Owner.$names;
Speeds.$compared = Speeds.$names;
Sliding.$compared = Sliding.$names;
VariableSpeed.$compared = VariableSpeed.$names;
VariableSpeed.LIMITS = VariableSpeed.prototype.LIMITS = $ca384;
Sizes.$compared = Sizes.$names;
MassRange.$compared = MassRange.$names;
Verdict.$compared = Verdict.$names;
Figure.$compared = Figure.$names;
StandardRequirement.$compared = StandardRequirement.$names;
LeastTension.$compared = LeastTension.$names;
Row.$compared = Row.$names;
Table.$compared = Table.$names;
FrictionLaw.$compared = FrictionLaw.$names;
Constant.$compared = Constant.$names;
Constant.title = Constant.prototype.title = "constant friction (Euler-Eytelwein)";
PressurePower.$compared = PressurePower.$names;
PressurePower.title = PressurePower.prototype.title = "power of pressure";
ClassicalDrive.$compared = ClassicalDrive.$names;
Input.$compared = Input.$names;
$sig(Sources, [], false);
TestedRange.$compared = TestedRange.$names;
MeasuredTable.$compared = MeasuredTable.$names;
MeasuredTable.title = MeasuredTable.prototype.title = "measured table";
_Term.$compared = _Term.$names;
Trend.$compared = Trend.$names;
Piece.$compared = Piece.$names;
CoefficientPieces.$compared = CoefficientPieces.$names;
PressureKnots.$compared = PressureKnots.$names;
IntegralLog.$compared = IntegralLog.$names;
IntegralLog.title = IntegralLog.prototype.title = "integral-log law";
Factors.$compared = Factors.$names;
Lagging.$compared = ["name", "law", "thickness", "shear_modulus", "compression_modulus", "title", "condition", "surface", "elastic_modulus", "wear_coefficient", "belt_energy_share", "bond_strength", "fatigue_limit", "cost", "fit", "factors", "condition_factors", "uncertainty", "provenance", "sources", "scaled_by", "notes", "description"];
Lagging.LIMITS = Lagging.prototype.LIMITS = $c98ae;
LoadGiven.$compared = LoadGiven.$names;
DrumAt.$compared = DrumAt.$names;
Pair.$compared = Pair.$names;
TorqueFollower.$compared = TorqueFollower.$names;
TorqueFollower.LIMITS = TorqueFollower.prototype.LIMITS = $c2d26;
RunsGain.$compared = RunsGain.$names;
BehindTakeUp.$compared = BehindTakeUp.$names;
Growth.$compared = Growth.$names;
Description.$compared = Description.$names;
Load.$compared = Load.$names;
DataLine.$compared = DataLine.$names;
CompactLaw.$compared = CompactLaw.$names;
TakeUp.$compared = TakeUp.$names;
TakeUp.LIMITS = TakeUp.prototype.LIMITS = $c3530;
DesignStandard.$compared = DesignStandard.$names;
DesignStandard.LIMITS = DesignStandard.prototype.LIMITS = $ce0a3;
SafetyFactors.$compared = SafetyFactors.$names;
SafetyFactors.LIMITS = SafetyFactors.prototype.LIMITS = $cc53c;
$sig(Kind.prototype.built, ["value", "report"], true);
$sig(tables$Table, null);
$sig(tables$Table.prototype.built, ["value", "report"], true);
Limit.$compared = Limit.$names;
DimensionText.$compared = DimensionText.$names;
Definition.$compared = Definition.$names;
Usual.$compared = Usual.$names;
Cords.$compared = Cords.$names;
Belt.$compared = Belt.$names;
Belt.LIMITS = Belt.prototype.LIMITS = $c2a894;
Across.$compared = Across.$names;
Across.LIMITS = Across.prototype.LIMITS = $cf7bc;
$sig(Variant, ["tag", "meaning"], false);
$sig(Variant.prototype.built, ["value", "report"], true);
Pulley.$compared = Pulley.$names;
Pulley.LIMITS = Pulley.prototype.LIMITS = $c7ba7;
Sag.$compared = Sag.$names;
Sag.SOURCE = Sag.prototype.SOURCE = "belt sag: T = m' g l/(8 h), a parabola; the rule of DIN 22101 and of CEMA, Belt Conveyors for Bulk Materials (6.25 S W for 2 %, 4.2 S W for 3 %)";
Sag.LIMITS = Sag.prototype.LIMITS = $c2d0e;
Flight.$compared = Flight.$names;
Flight.LIMITS = Flight.prototype.LIMITS = $c1fb5;
LoadingPoint.$compared = LoadingPoint.$names;
LoadingPoint.LIMITS = LoadingPoint.prototype.LIMITS = $cf8c9;
ConveyorCase.$compared = ConveyorCase.$names;
Travel.$compared = Travel.$names;
Travel.LIMITS = Travel.prototype.LIMITS = $c01b1;
Cema.$compared = Cema.$names;
Cema.LIMITS = Cema.prototype.LIMITS = $cdc48;
ConveyorData.$compared = ConveyorData.$names;
ConveyorData.LIMITS = ConveyorData.prototype.LIMITS = $cc312;
Conveyor.$compared = Conveyor.$names;
DesignFriction.$compared = DesignFriction.$names;
KeyFigure.$compared = KeyFigure.$names;
LaggingCost.$compared = LaggingCost.$names;
ModulusRatio.$compared = ModulusRatio.$names;
Cost.$compared = Cost.$names;
Cost.LIMITS = Cost.prototype.LIMITS = $c75fc;
Block.$compared = Block.$names;
Block.LIMITS = Block.prototype.LIMITS = $cd06c;
ConditionFactor.$compared = ConditionFactor.$names;
ConditionFactor.LIMITS = ConditionFactor.prototype.LIMITS = $c6e1f0;
FrictionFactor.$compared = FrictionFactor.$names;
Fit.$compared = Fit.$names;
FileKind.$compared = FileKind.$names;
Induction.$compared = Induction.$names;
Induction.LIMITS = Induction.prototype.LIMITS = $c19bc;
FluidCoupling.$compared = FluidCoupling.$names;
ElongationAt.$compared = ElongationAt.$names;
Transition.$compared = Transition.$names;
Transition.LIMITS = Transition.prototype.LIMITS = $c56ea;
TiltResistance.$compared = TiltResistance.$names;
TiltResistance.LIMITS = TiltResistance.prototype.LIMITS = $c0a0b;
PulleyResistance.$compared = PulleyResistance.$names;
PulleyResistance.LIMITS = PulleyResistance.prototype.LIMITS = $ccbd6;
$sig(PulleyResistance.prototype.wrap, ["tension", "width", "thickness", "steel"], false);
loop$Spot.$compared = loop$Spot.$names;
PointResistance.$compared = PointResistance.$names;
PointResistance.LIMITS = PointResistance.prototype.LIMITS = $c5706;
SkirtResistance.$compared = SkirtResistance.$names;
SkirtResistance.LIMITS = SkirtResistance.prototype.LIMITS = $c71085;
Segment.$compared = Segment.$names;
CleanerResistance.$compared = CleanerResistance.$names;
CleanerResistance.LIMITS = CleanerResistance.prototype.LIMITS = $c80b6;
DrivePull.$compared = DrivePull.$names;
state$State.$compared = state$State.$names;
Resistance.$compared = Resistance.$names;
BeltPoint.$compared = BeltPoint.$names;
Stretch.$compared = Stretch.$names;
Standstill.$compared = Standstill.$names;
ElasticPlastic.$compared = ElasticPlastic.$names;
ElasticPlastic.title = ElasticPlastic.prototype.title = "elastic-plastic";
$sig(Profile, ["dimension", "diameters"], false);
Profile.words = Profile.prototype.words = "rows, or a table";
$sig(_Pair, ["dimension"], false);
GrippingPulley.$compared = GrippingPulley.$names;
GrippingPulley.LIMITS = GrippingPulley.prototype.LIMITS = $cfa4c;
Misplaced.$compared = Misplaced.$names;
LoadedFlights.names = LoadedFlights.prototype.names = $c3d72;
Either.$compared = Either.$names;
SpeedList.$compared = SpeedList.$names;
SpeedList.rows = SpeedList.prototype.rows = $cd950;
$sig(sheet__row_of, null);
$sig(sheet__between, ["name", "first", "last", "form"], false);
export { drive_file__drive_from_document as readDrive };
export { file__train_from_document as readTrain };
export { InputError as InputError };
export { CatalogueBelt as CatalogueBelt };
export { Provenance as Provenance };
export { source__syntax_problem as syntaxProblem };
export { in_page_checks__arcs_of as arcsOf };
export { in_page_checks__given_of as givenOf };
export { in_page_checks__criteria_of as criteriaOf };
export { in_page_checks__results_of as resultsOf };
export { in_page_checks__result_of as resultOf };
export { in_page_checks__train_drive as trainDrive };
export { in_page_checks__running_at as runningAt };
export { TrainResult as TrainResult };
export { CaseResult as CaseResult };
export { MemberResult as MemberResult };
export { in_page_checks__alone as alone };
export { in_page_checks__remarks_of as remarksOf };
export { in_page_checks__weak_kinds as weakKinds };
export { in_page_checks__idle_in as idleIn };
export { judge__judge as judge };
export { least_tension__least_tension as leastTension };
export { least_tension__least_sentence as leastSentence };
export { least_tension__least_table as leastTable };
export { least_tension__shown_least as shownLeast };
export { checks_table__check_table as checkTable };
export { words__short as short };
export { words__order_in as orderIn };
export { drive_sheet__summary_table as summaryTable };
export { drive_sheet__arc_tables as arcTables };
export { Sources as Sources };
export { words__alone_of as aloneOf };
