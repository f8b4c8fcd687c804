/** Companions of bridges (records, drawings, packings) in IndexedDB: too large for the store that holds the texts. */
const NAME = "extrados";
const STORE = "files";

function database(): Promise<IDBDatabase | null> {
  return new Promise((resolve) => {
    try {
      const request = indexedDB.open(NAME, 1);
      request.onupgradeneeded = () => request.result.createObjectStore(STORE);
      request.onsuccess = () => resolve(request.result);
      request.onerror = () => resolve(null);
      request.onblocked = () => resolve(null);
    } catch {
      resolve(null);
    }
  });
}

async function inStore<T>(mode: IDBTransactionMode, ask: (store: IDBObjectStore) => IDBRequest<T>): Promise<T | undefined> {
  const open = await database();
  if (!open) return undefined;
  return new Promise((resolve) => {
    try {
      const request = ask(open.transaction(STORE, mode).objectStore(STORE));
      request.onsuccess = () => resolve(request.result);
      request.onerror = () => resolve(undefined);
    } catch {
      resolve(undefined);
    }
  }).then((value) => {
    open.close();
    return value as T | undefined;
  });
}

export async function keepFiles(sheet: string, files: [string, Uint8Array][]): Promise<void> {
  await inStore("readwrite", (store) => store.put(files, sheet));
}
export async function filesOf(sheet: string): Promise<[string, Uint8Array][]> {
  const found = await inStore<unknown>("readonly", (store) => store.get(sheet));
  return Array.isArray(found) ? (found as [string, Uint8Array][]) : [];
}
export async function forgetFiles(sheet: string): Promise<void> {
  await inStore("readwrite", (store) => store.delete(sheet));
}
