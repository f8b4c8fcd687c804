/** Records and what the model makes of them, before an update and after it, over one time. */
export type Histories = { times: number[]; channels: { name: string; unit: string; measured: number[]; start: number[]; updated: number[] }[] };

/** Of `histories.csv` as an update writes it: time, position, and for each channel what was measured and computed before and after. */
export function historiesOf(table: string): Histories {
  const [head, ...rows] = table.trim().split(/\r?\n/).map((line) => line.split(","));
  const column = (k: number): number[] => rows.map((row) => (row[k] === undefined || row[k] === "" ? NaN : Number(row[k])));
  const channels: Histories["channels"] = [];
  (head ?? []).forEach((name, k) => {
    const match = /^(.+)_(measured|start|updated)_([^_]+)$/.exec(name);
    if (!match) return;
    const [, slug, which, unit] = match as unknown as [string, string, "measured" | "start" | "updated", string];
    const title = slug.replace(/_/g, " ");
    let channel = channels.find((one) => one.name === title && one.unit === unit);
    if (!channel) channels.push((channel = { name: title, unit, measured: [], start: [], updated: [] }));
    channel[which] = column(k);
  });
  return { times: column(0), channels };
}
