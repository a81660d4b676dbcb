// The style sheet of drawings, for those that come without a page: web/build.ts defines it for widgets. Pages have it
// in their heads.

declare global {
  var DRAWING_STYLES: string | undefined;
}

export const STYLE = globalThis.DRAWING_STYLES;
