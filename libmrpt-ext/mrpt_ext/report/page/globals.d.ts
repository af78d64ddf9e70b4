// Dygraphs (Debian: libjs-dygraphs) is part of the page; it has no types of its own.
declare const Dygraph: any;
