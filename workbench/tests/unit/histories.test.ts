import { describe, expect, it } from "vitest";
import { historiesOf } from "../../src/model/histories";

describe("histories of an update", () => {
  it("are the three columns of each channel, with gaps where a record has none", () => {
    const found = historiesOf("time_s,position_m,crown_measured_mm,crown_start_mm,crown_updated_mm,pier_strain_measured_microstrain\n0,1,-0.1,-0.2,-0.15,3\n0.5,2,,-0.4,-0.3,4\n");
    expect(found.times).toEqual([0, 0.5]);
    expect(found.channels.map((one) => `${one.name}, ${one.unit}`)).toEqual(["crown, mm", "pier strain, microstrain"]);
    expect(found.channels[0]).toMatchObject({ measured: [-0.1, NaN], start: [-0.2, -0.4], updated: [-0.15, -0.3] });
  });
  it("are none where there is no table", () => {
    expect(historiesOf("").channels).toEqual([]);
  });
});
