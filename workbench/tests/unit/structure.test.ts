import { describe, expect, it } from "vitest";
import { countOf, inserted, repeated, stretchOf, withWord, without } from "../../src/model/structure";

const FILE = `# a bridge
[bridge]
name = "x [[span]]"

# the first
[[span]]
span = "5 m"
[[span.ring]]
thickness = "0.2 m"

# the second
[[span]]
span = "6 m"

[masonry]
density = "2000 kg/m^3"
`;

describe("tables of the text", () => {
  it("are counted by their headers alone, not by what strings say", () => {
    expect(countOf(FILE, "span")).toBe(2);
    expect(countOf(FILE, "pier")).toBe(0);
  });
  it("carry their comments and what is nested in them", () => {
    const first = stretchOf(FILE, "span", 1)!;
    expect(FILE.slice(first.start, first.end)).toContain("# the first");
    expect(FILE.slice(first.start, first.end)).toContain("[[span.ring]]");
    expect(FILE.slice(first.start, first.end)).not.toContain("6 m");
  });
  it("are repeated below themselves", () => {
    const more = repeated(FILE, "span")!;
    expect(countOf(more, "span")).toBe(3);
    expect(more.match(/6 m/g)).toHaveLength(2);
    expect(more.indexOf("[masonry]")).toBeGreaterThan(more.lastIndexOf("6 m"));
  });
  it("are put in at the end of their list and taken out again", () => {
    const more = inserted(FILE, "cover", 'layer = "fill"');
    expect(more.trim().endsWith('layer = "fill"')).toBe(true);
    expect(countOf(without(FILE, "span", 1), "span")).toBe(1);
    expect(without(FILE, "span", 1)).not.toContain("span.ring");
    expect(without(FILE, "span", 9)).toBe(FILE);
  });
  it("have their words written anew in their own table alone", () => {
    const text = 'place = "no"\n[records]\n# place = "no"\nplace = "old.csv"  # ours\n[x]\nplace = "no"\n';
    expect(withWord(text, "records", "place", 'new".csv')).toBe(text.replace("old.csv", "new.csv"));
    expect(withWord(text, "nothing", "place", "a")).toBe(text);
    expect(withWord(text, "records", "other", "a")).toBe(text);
  });
});
