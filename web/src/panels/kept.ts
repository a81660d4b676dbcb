// What a reader's browser keeps for the next visit; where it keeps nothing, nothing is missed.

export interface Kept {
  read(): string | null;
  write(text: string): void;
}

/** `name`: under which it is kept. */
export const kept = (name: string): Kept => ({
  read() {
    try {
      return localStorage.getItem(name);
    } catch {
      return null;
    }
  },
  write(text) {
    try {
      localStorage.setItem(name, text);
    } catch {
      // A page from disk may have no store.
    }
  },
});
