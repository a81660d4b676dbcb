// Frames while a drawing plays.

export interface Playback {
  readonly running: boolean;
  start(): void;
  stop(): void;
}

/** `advance` is told the seconds since the last frame, `changed` whether it plays. */
export function playback(advance: (seconds: number) => void, changed: (playing: boolean) => void): Playback {
  let tick = 0;
  return {
    get running() {
      return tick !== 0;
    },
    start() {
      if (tick) return;
      changed(true);
      let before: number | null = null;
      const step = (stamp: number) => {
        // A hidden tab stops the frames: on return it goes on from where it stood.
        const elapsed = before === null ? 0 : Math.min(stamp - before, 100) / 1000;
        before = stamp;
        tick = requestAnimationFrame(step);
        advance(elapsed);
      };
      tick = requestAnimationFrame(step);
    },
    stop() {
      cancelAnimationFrame(tick);
      tick = 0;
      changed(false);
    },
  };
}
