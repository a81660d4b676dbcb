// A report without charts of studies has a script that leaves out what only these need: web/build.ts defines this
// constant for it, and branches behind it are dropped. Elsewhere it isn't there.

declare global {
  var WITHOUT_STUDIES: true | undefined;
}

export {};
