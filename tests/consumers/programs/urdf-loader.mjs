// What urdf-loader (three.js) makes of the robots that standard input names, a line of JSON each. Meshes are not loaded.
import { readFileSync } from 'node:fs';
import { JSDOM } from 'jsdom';

const { window } = new JSDOM('');
globalThis.DOMParser = window.DOMParser;
globalThis.XMLSerializer = window.XMLSerializer;
globalThis.Document = window.Document;
globalThis.Element = window.Element;
globalThis.document = window.document;
const { Object3D } = await import('three');
const { default: Loader } = await import('urdf-loader');
console.warn = () => {};
console.error = () => {};
console.log = console.log.bind(console);

const loader = new Loader();
loader.loadMeshCb = (path, manager, material, done) => done(new Object3D());
const number = value => (Number.isFinite(value) ? value : null);

function read(file) {
    const robot = loader.parse(readFileSync(file, 'utf8'), '/');
    const links = Object.fromEntries(Object.keys(robot.links).map(name => [name, null]));
    const joints = Object.fromEntries(Object.entries(robot.joints).map(([name, joint]) =>
        [name, [joint.jointType, number(joint.limit.lower), number(joint.limit.upper)]]));
    return { loaded: true, links, joints, bodies: null };
}

for (const file of readFileSync(0, 'utf8').split('\n').filter(Boolean)) {
    let answer;
    try {
        answer = read(file);
    } catch (error) {
        answer = { loaded: false, why: String(error).slice(0, 300) };
    }
    process.stdout.write(JSON.stringify({ file, ...answer }) + '\n');
}
