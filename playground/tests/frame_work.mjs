// Reads the work of frames out of a trace of Chromium.

/** What a trace must contain. */
export const TRACED = ['devtools.timeline', 'disabled-by-default-devtools.timeline'];

/** The main thread of the page: the one that draws the most frames. */
function mainThread(frames) {
  const counts = new Map();
  for (const { pid, tid } of frames) counts.set(`${pid} ${tid}`, (counts.get(`${pid} ${tid}`) ?? 0) + 1);
  return [...counts].sort(([, a], [, b]) => b - a)[0]?.[0];
}

/**
 * Returns the work of each frame in milliseconds: the tasks of the main thread from the end of the frame before to the end of
 * this frame. A frame ends with the task that runs its animation callbacks. `time` is the time from the begin to the end of
 * the tasks. It depends on the other programs of the machine and on the other threads of the browser, for which a task waits.
 * `processor` is the processor time of the tasks.
 */
export function frameWork({ traceEvents }) {
  const callbacks = traceEvents.filter(({ name }) => name === 'FireAnimationFrame');
  const thread = mainThread(callbacks);
  const isMain = ({ pid, tid }) => `${pid} ${tid}` === thread;
  const tasks = traceEvents.filter((event) => event.name === 'RunTask' && event.ph === 'X' && isMain(event)).sort((a, b) => a.ts - b.ts);
  const begins = callbacks.filter(isMain).map(({ ts }) => ts).sort((a, b) => a - b);
  if (tasks.length === 0 || begins.length === 0) throw new Error('the trace has no frames');
  const work = { time: [], processor: [] };
  let [time, processor, next, isFirst] = [0, 0, 0, true];
  for (const { ts, dur = 0, tdur = dur } of tasks) {
    time += dur / 1000;
    processor += tdur / 1000;
    const end = ts + dur;
    const before = next;
    while (next < begins.length && begins[next] < end) ++next;
    if (next === before) continue;
    // The trace may have begun in the middle of the first frame.
    if (!isFirst) {
      work.time.push(time);
      work.processor.push(processor);
    }
    [time, processor, isFirst] = [0, 0, false];
  }
  return work;
}
