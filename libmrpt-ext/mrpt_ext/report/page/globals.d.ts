// What the page brings along: Dygraphs (Debian: libjs-dygraphs), without types of its own.
declare const Dygraph: any;
