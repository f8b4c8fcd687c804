/** The answer of an assessment first, in the words of the trade. Nothing is said that the result does not have. */
import { figures } from "../units";

type Check = { code: string; title: string; load_model?: string; value: number | null; limit: number | null; utilisation: number | null; met: boolean };
type Graded = { of: string; highest: string | null; carried: string[]; not_carried: string[]; unanswered: string[] };
/** What is read of `result.json`. */
export type Assessed = {
  status?: string;
  headline?: string;
  head?: string;
  by_name?: string;
  level?: string | null;
  strength_assessed?: boolean;
  governing?: { code: string; title: string; load_model?: string; utilisation: number | null } | null;
  checks?: Check[];
  vehicles?: { vehicles?: { code: string; title: string }[]; graded?: Graded[] } | null;
};

/** `says` is the verdict, `governs` what decides it, `carries` what is carried and what is not, `with` what it is to be read with. */
export type Trade = { says: string; governs: string; carries: string[]; with: string };

/** Vehicles that are named before the others are counted. */
const MOST_NAMED = 5;
const listed = (names: string[], between = "; "): string => (names.length > MOST_NAMED + 1 ? `${names.slice(0, MOST_NAMED).join(between)} and ${names.length - MOST_NAMED} more` : names.join(between));

export function trade(found: Assessed): Trade | null {
  const says = found.headline;
  if (says === undefined) return null;
  // The head names rule and grade where the verdict is by them.
  const level = found.level ? ` for ${found.level}` : "";
  const whole = `${says} by ${found.by_name ?? ""}${level}`;
  const head = found.head ?? "";
  const ruled = head.startsWith(whole);
  const rest = ruled ? head.slice(whole.length) : head.startsWith(says) ? head.slice(says.length) : head;
  return { says: ruled ? says + level : says, governs: governs(found), carries: carries(found), with: rest.replace(/^: carries [^(]*/, "").trim().replace(/^\((.*)\)$/s, "$1").replace(/^./, (c) => c.toUpperCase()) };
}

const titleOf = (found: Assessed, code: string | undefined): string => found.vehicles?.vehicles?.find((one) => one.code === code)?.title ?? code ?? "";

function governs(found: Assessed): string {
  const one = found.governing;
  if (!one) return "";
  const check = found.checks?.find((check) => check.code === one.code && check.load_model === one.load_model && check.utilisation === one.utilisation);
  if (one.code === "C204" && check && typeof check.value === "number" && typeof check.limit === "number") return `${titleOf(found, one.load_model)} governs: factor ${figures(check.value, 3)}, ${figures(check.limit, 3)} is asked for`;
  const title = one.title.replace(/^./, (c) => c.toUpperCase());
  return typeof one.utilisation === "number" ? `${title}${one.load_model ? `, ${titleOf(found, one.load_model)},` : ""} governs: ${figures(100 * one.utilisation, 3)} % of its limit is used` : `${title} governs`;
}

function carries(found: Assessed): string[] {
  const checks = (found.checks ?? []).filter((check) => check.code === "C204");
  const graded = found.vehicles?.graded ?? [];
  // What is carried with strength left out of account is no more than a factor.
  const sure = found.strength_assessed === true && (found.status === "adequate" || found.status === "inadequate");
  const words = sure ? ["Carries", "does not carry"] : ["Factor of 1 or more", "less than 1"];
  const lines = graded.map(({ of, highest, not_carried, unanswered }) => {
    const first = not_carried[0] ?? unanswered[0];
    const parts = [highest ? `${sure ? "carries" : "factor of 1 or more for"} ${highest}` : first ? `less than ${first}` : "nothing is settled"];
    if (highest && not_carried.length > 0) parts.push(`${sure ? "not " : "less for "}${listed(not_carried, ", ")}`);
    if (unanswered.length > 0) parts.push(`not settled: ${listed(unanswered, ", ")}`);
    return `${of.replace(/^./, (c) => c.toUpperCase())}: ${parts.join(", ")}`;
  });
  // Vehicles that stand for grades have been told by these.
  const all = graded.reduce((sum, one) => sum + one.carried.length + one.not_carried.length + one.unanswered.length, 0);
  if (checks.length === 0 || (all > 0 && all >= checks.length)) return lines;
  const [yes, no] = [true, false].map((met) => checks.filter((check) => check.met === met).map((check) => titleOf(found, check.load_model)));
  if (no!.length === 0) return [...lines, `${words[0]}: ${yes!.length > MOST_NAMED + 1 ? `all ${yes!.length} vehicles that were asked for` : listed(yes!)}`];
  return [...lines, `${yes!.length > 0 ? `${words[0]}: ${listed(yes!)}` : sure ? "Carries none of the vehicles that were asked for" : "No vehicle has a factor of 1"}`, ...(yes!.length > 0 ? [`${words[1]!.replace(/^./, (c) => c.toUpperCase())}: ${listed(no!)}`] : [])];
}
