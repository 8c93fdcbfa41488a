/** The bundle of `mesh_worker.ts` as text: build.mjs makes it. */
declare module 'mesh-worker' {
  const source: string;
  export default source;
}
