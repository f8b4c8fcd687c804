import { describe, expect, it } from "vitest";
import { fromFragment, MOST_ADDRESS, MOST_UNFOLDED, toFragment } from "../../src/model/address";

describe("a bridge in the address", () => {
  it("comes back as it went in", async () => {
    const shared = { path: "bridge.toml", text: '[bridge]\nname = "Brücke ✓"\n'.repeat(20), vehicle: "lm71", x: 4.5 };
    const fragment = await toFragment(shared);
    expect(fragment.length).toBeLessThan(shared.text.length);
    expect(fragment).toMatch(/^#b=[\w-]+$/);
    expect(await fromFragment(fragment)).toEqual(shared);
  });
  it("is refused in words where it is cut, no bridge, too long or a bomb", async () => {
    const fragment = await toFragment({ path: "a.toml", text: "x = 1\n".repeat(200) });
    await expect(fromFragment(fragment.slice(0, fragment.length - 20))).rejects.toThrow(/not whole/);
    await expect(fromFragment("#b=%%%")).rejects.toThrow(/not whole/);
    await expect(fromFragment(`#b=${"A".repeat(MOST_ADDRESS)}`)).rejects.toThrow(/longer/);
    const bomb = await toFragment({ path: "a.toml", text: "0".repeat(40 * MOST_UNFOLDED) });
    expect(bomb.length).toBeLessThan(MOST_ADDRESS);
    await expect(fromFragment(bomb)).rejects.toThrow(/unfolds/);
    expect(await fromFragment("#answer")).toBeNull();
  });
  it("keeps names of files harmless", async () => {
    const fragment = await toFragment({ path: "../../<img src=x onerror=alert(1)>.toml", text: "" });
    expect((await fromFragment(fragment))!.path).not.toMatch(/[<>/]/);
  });
});
