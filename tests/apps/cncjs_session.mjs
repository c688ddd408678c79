// SPDX-License-Identifier: MIT
// The sender CNCjs, as npm has it, at `softcnc serve`: by its own socket it homes, jogs, sets zero,
// runs programs, holds, overrides, resumes, resets and unlocks. Each program ends at the counts of
// `softcnc run` from the same place, and has moved each axis as far.
//
//   node tests/apps/cncjs_session.mjs SOFTCNC FOLDER      FOLDER/node_modules has the package cncjs
import { spawn, spawnSync } from 'node:child_process';
import fs from 'node:fs';
import { createRequire } from 'node:module';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const kRoot = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
const kMachine = path.join(kRoot, 'programs/31_first_part.toml');
const kAxes = ['x', 'y', 'z'];
const kBlu = 0.0025; // mm, of each axis of kMachine
const kHome = [-150, -100, 60]; // where homing of kMachine ends
const kZero = [-60, -40, 30]; // where the programs begin: all of them fit in the travel from there
const kStateFile = 'state.toml';
const kTravel = 0.05; // mm, by which the travel of an axis may differ: rows lie elsewhere on the path
const kLinesShown = 15; // of what CNCjs has heard, where a step fails

const began = performance.now();
const processes = [];

class Failure extends Error {}

function fail(what, expected, came) {
  throw new Failure(`${what}\n  expected: ${expected}\n  came:     ${came}`);
}

const programFile = (name) => path.join(kRoot, 'programs', `${name}.nc`);
const delay = (seconds) => new Promise((resolve) => { setTimeout(resolve, 1000 * seconds); });
const show = (place) => place.map((value) => value.toFixed(3)).join(' ');
const near = (a, b) => a.every((value, k) => Math.abs(value - b[k]) <= kBlu);

function say(what) {
  console.log(`ok ${((performance.now() - began) / 1000).toFixed(1).padStart(6)} s  ${what}`);
}

/** Calls `found` until it returns something, which is returned; after `seconds`, undefined. */
async function poll(seconds, found) {
  for (const end = performance.now() + 1000 * seconds; performance.now() < end; await delay(0.02)) {
    const value = found();
    if (value) return value;
  }
  return undefined;
}

/** A program that runs beside this one, and whose output goes to a file. */
class Process {
  ended = null;

  constructor(name, folder, command, options, environment = {}) {
    this.name = name;
    this.log = path.join(folder, `${name}.log`);
    const output = fs.openSync(this.log, 'w');
    this.child = spawn(command, options,
      { cwd: folder, env: { ...process.env, ...environment }, stdio: ['ignore', output, output] });
    fs.closeSync(output);
    this.child.on('error', (error) => { this.ended = error.message; });
    this.child.on('exit', (code, signal) => { this.ended ??= String(code ?? signal); });
    processes.push(this);
  }

  printed() {
    return fs.readFileSync(this.log, 'utf8').replace(/\x1b\[\d*m/g, '');
  }

  /** Waits for what it prints. */
  async prints(pattern, seconds) {
    const match = await poll(seconds, () => this.printed().match(pattern) ?? this.ended !== null);
    if (match?.length) return match;
    return fail(`${this.name} starts`, `${pattern} within ${seconds} s`,
      `${this.printed()}(${this.ended === null ? 'runs' : `ended: ${this.ended}`})`);
  }

  async stop() {
    this.child.kill('SIGTERM');
    await poll(10, () => this.ended !== null);
    return this.ended;
  }
}

/** What the machine is, as CNCjs says it, and the commands of CNCjs. */
class Client {
  state = { active: '', sub: 0, place: [NaN, NaN, NaN], overrides: '' };
  workflow = '';
  sender = { sent: 0, received: 0, total: 0, holdReason: null };
  answered = 0; // lines of the program, at most: CNCjs forgets their number once it ends
  heard = [];

  constructor(io, url, token, port) {
    this.port = port;
    this.socket = io(url, { query: { token }, reconnection: false });
    this.socket.on('controller:state', (_, { status }) => this.keepStatus(status ?? {}));
    this.socket.on('workflow:state', (state) => { this.workflow = state; });
    this.socket.on('serialport:read', (line) => { this.heard.push(line); });
    this.socket.on('sender:status', (status) => {
      this.sender = status;
      this.answered = Math.max(this.answered, status.received);
    });
  }

  keepStatus({ activeState = '', subState = 0, mpos = {}, ov = [] }) {
    this.state = { active: activeState, sub: subState, place: kAxes.map((axis) => Number(mpos[axis])),
                   overrides: ov.join(' ') };
  }

  connect() {
    return new Promise((resolve, reject) => {
      this.socket.on('startup', resolve);
      for (const event of ['connect_error', 'error'])
        this.socket.on(event, (error) => reject(new Failure(`CNCjs refuses its client: ${error}`)));
    });
  }

  open() {
    const options = { controllerType: 'Grbl', baudrate: 115200 };
    return new Promise((resolve, reject) => {
      this.socket.emit('open', this.port, options, (error) => (error
        ? reject(new Failure(`CNCjs cannot open ${this.port}: ${JSON.stringify(error)}`)) : resolve()));
    });
  }

  command(...words) {
    this.socket.emit('command', this.port, ...words);
  }

  describe() {
    const { active, sub, place, overrides } = this.state;
    const { sent, received, total, holdReason } = this.sender;
    return `${active}:${sub} at ${show(place)}, overrides ${overrides}, workflow ${this.workflow}, ` +
      `of ${total} lines ${sent} sent and ${received} answered, hold ${JSON.stringify(holdReason)}`;
  }

  /** Waits until `holds`; an error or an alarm that comes first is a failure. */
  async until(what, expected, seconds, holds) {
    const bad = () => this.heard.find((line) => /^(error|ALARM)/.test(line)) ??
      processes.filter(({ ended }) => ended !== null).map(({ name }) => `the end of ${name}`)[0];
    await poll(seconds, () => holds() || bad());
    if (bad() !== undefined) fail(what, expected, `${bad()}; ${this.describe()}`);
    if (!holds()) fail(what, `${expected} within ${seconds} s`, this.describe());
  }

  isAt(place) {
    return near(this.state.place, place);
  }

  idleAt(what, place, seconds) {
    return this.until(what, `Idle at ${show(place)}`, seconds,
      () => this.state.active === 'Idle' && this.isAt(place));
  }

  active(what, name, seconds) {
    return this.until(what, name, seconds, () => this.state.active === name && this.state.sub === 0);
  }
}

/** Both programs, and the client; `folder` has their files. */
async function startAll(softcnc, cncjs, folder) {
  const port = path.join(folder, 'grbl');
  const configuration = path.join(folder, 'cncrc.json');
  fs.writeFileSync(configuration, JSON.stringify(
    { ports: [{ path: port }], state: { checkForUpdates: false } }));
  const serve = new Process('softcnc', folder, softcnc, ['serve', '--machine', kMachine, '--pty', port,
    '--state', kStateFile, '--trace', 'session.csv']);
  await serve.prints(/serves grbl/, 10);
  const main = path.join(cncjs, 'node_modules/cncjs/bin/cncjs');
  const sender = new Process('cncjs', folder, process.execPath,
    [main, '--host', '127.0.0.1', '--port', '0', '--config', configuration], { HOME: folder });
  const [, url] = await sender.prints(/(http:\/\/127\.0\.0\.1:\d+)/, 30);
  const io = createRequire(path.join(cncjs, 'node_modules/cncjs/package.json'))('socket.io-client');
  const { token } = await (await fetch(`${url}/api/signin`, { method: 'POST' })).json();
  const client = new Client(io, url, token, port);
  await client.connect();
  return { softcnc, folder, serve, sender, client };
}

async function connect({ client }) {
  await client.open();
  await client.active('CNCjs opens the port', 'Alarm', 10);
  say('CNCjs has opened the pseudo-terminal: Alarm, for nobody knows where the machine stands');
}

async function home({ client }) {
  client.command('homing');
  await client.idleAt('homing', kHome, 20);
  say(`homed: Idle at ${show(client.state.place)}`);
}

async function jog({ client }) {
  const [x, y, z] = kZero.map((value, k) => value - kHome[k]);
  client.command('gcode', `$J=G91 X${x} Y${y} Z${z} F12000`);
  await client.idleAt('a jog', kZero, 10);
  say(`jogged: Idle at ${show(client.state.place)}`);
}

const readState = ({ folder }) => fs.readFileSync(path.join(folder, kStateFile), 'utf8');

/** The place that a table of the state file holds. */
function placeIn(state, table) {
  const text = state.split(`[${table}]`)[1]?.split('\n[')[0] ?? '';
  return kAxes.map((axis) => Number(text.match(new RegExp(`^${axis}_mm = (.*)$`, 'm'))?.[1]));
}

/** The state file, once it says that the machine rests. */
async function stateAtRest(session) {
  const atRest = () => [readState(session)].find((state) => state.includes('in_motion = "no"'));
  return await poll(5, atRest) ?? fail('the state file', 'in_motion = "no"', readState(session));
}

async function setZero(session) {
  session.client.command('gcode', 'G10 L20 P1 X0 Y0 Z0');
  const origin = () => placeIn(readState(session), 'work."G54"');
  await poll(5, () => near(origin(), kZero));
  if (!near(origin(), kZero)) fail('G10 L20', `G54 at ${show(kZero)}`, show(origin()));
  say('zero set: G54 begins there');
}

/** Moves away from zero and back; these rows part the programs in the trace of the session. */
async function returnToZero({ client }) {
  client.command('gcode', '$J=G90 X5 Y5 Z5 F12000');
  await client.idleAt('a jog away from zero', kZero.map((value) => value + 5), 10);
  client.command('gcode', '$J=G90 X0 Y0 Z0 F12000');
  await client.idleAt('a jog to zero', kZero, 10);
}

/** How far each axis has moved over some rows of a trace. */
const travelOf = (rows) => kAxes.map((_, axis) =>
  rows.slice(1).reduce((sum, { place }, k) => sum + Math.abs(place[axis] - rows[k].place[axis]), 0));

/** The rows of a trace: { line, place }. */
function readTrace(file) {
  const text = fs.readFileSync(file, 'utf8').split('\n');
  const [header, ...rows] = text.filter((row) => row !== '' && row[0] !== '#').map((row) => row.split(','));
  const [line, ...axes] = ['line', ...kAxes.map((axis) => `${axis}_mm`)].map((name) => header.indexOf(name));
  return rows.map((row) => ({ line: Number(row[line]), place: axes.map((column) => Number(row[column])) }));
}

/** What `softcnc run` makes of a program, from where the state file says that the machine stands. */
function runAlone({ softcnc, folder }, name, state) {
  const file = (suffix) => path.join(folder, `${name}.${suffix}`);
  fs.writeFileSync(file('toml'), state);
  const { status, stderr, error } = spawnSync(softcnc, ['run', '-q', '--dialect', 'grbl',
    '--machine', kMachine, '--state', file('toml'), '--report', file('json'),
    '--trace', file('csv'), programFile(name)], { encoding: 'utf8', timeout: 20000 });
  if (status !== 0) fail(`softcnc run ${name}`, 'exit 0', `${status ?? error}: ${stderr}`);
  const { counts } = JSON.parse(fs.readFileSync(file('json'), 'utf8'));
  return { counts: kAxes.map((axis) => counts[axis]), travel: travelOf(readTrace(file('csv'))) };
}

/** Counts of a place, as reports give them: rounded to 1e-9 mm, then half away from zero. */
const countsOf = (place) => place.map((value) => {
  const counts = Math.abs(Number(value.toFixed(9))) / kBlu;
  return Math.sign(value) * Math.round(Number(counts.toFixed(6))) + 0;
});

/** Loads a program and begins it, `during` it does more; then compares where it has ended. */
async function runProgram(session, name, seconds, during = async () => {}) {
  const { client } = session;
  await returnToZero(session);
  const alone = runAlone(session, name, await stateAtRest(session));
  client.answered = 0;
  client.command('gcode:load', name, fs.readFileSync(programFile(name), 'utf8'));
  await client.until(`loading ${name}`, 'lines', 5, () => client.sender.name === name);
  const { total } = client.sender;
  client.command('gcode:start');
  await client.until(`${name} begins`, 'workflow running', 5, () => client.workflow !== 'idle');
  await during(client);
  await client.until(`${name} runs`, 'Idle, workflow idle', seconds,
    () => client.workflow === 'idle' && client.state.active === 'Idle');
  if (client.answered !== total) fail(`lines of ${name}`, `${total} answered`, client.answered);
  await compareEnd(session, name, alone.counts);
  say(`${name}: ${total} lines answered; ends at the counts ${alone.counts.join(' ')} of softcnc run`);
  return { name, travel: alone.travel };
}

async function compareEnd(session, name, counts) {
  const ends = () => countsOf(placeIn(readState(session), 'position')).join(' ');
  await poll(5, () => ends() === counts.join(' '));
  if (ends() !== counts.join(' ')) fail(`the end of ${name}, in counts`, counts.join(' '), ends());
  const place = counts.map((value) => value * kBlu);
  await session.client.idleAt(`the end of ${name}, as reported`, place, 5);
}

/** In the middle of a program: hold, a lower feed, resume. */
async function holdAndOverride(client) {
  await client.until('the curve', 'Run on it', 10,
    () => client.state.active === 'Run' && client.state.place[0] - kZero[0] > 80);
  client.command('feedhold');
  await client.active('feed hold', 'Hold', 5);
  const place = client.state.place;
  for (let k = 0; k < 3; ++k) client.command('feedOverride', -10);
  await client.until('overrides', 'overrides 70 100 100', 10, () => client.state.overrides === '70 100 100');
  if (!client.isAt(place)) fail('hold', `rest at ${show(place)}`, client.describe());
  say(`held at ${show(place)}; feed override 70 %`);
  client.command('cyclestart');
  await client.active('resuming', 'Run', 5);
  if (client.state.overrides !== '70 100 100') fail('resuming', 'overrides 70 100 100', client.describe());
  say('resumed');
}

/** CNCjs pauses at M6, and asks its user to go on. */
async function changeTool(client) {
  await client.until('M6', 'workflow paused for M6', 10,
    () => client.workflow === 'paused' && client.sender.holdReason?.data === 'M6');
  say('CNCjs has paused at M6');
  client.command('gcode:resume');
  await client.until('resuming after M6', 'workflow running', 5, () => client.workflow === 'running');
}

async function resetAndUnlock(session) {
  const { client } = session;
  await returnToZero(session);
  client.command('gcode', 'G1 X40 F1200');
  await client.until('a move to be reset', 'Run', 5,
    () => client.state.active === 'Run' && client.state.place[0] > kZero[0] + 1);
  client.command('reset');
  await poll(5, () => client.state.active === 'Alarm');
  const alarms = client.heard.filter((line) => line.startsWith('ALARM'));
  if (client.state.active !== 'Alarm' || alarms.length !== 1 || !alarms[0].startsWith('ALARM:3'))
    fail('a reset in motion', 'Alarm, and ALARM:3 once', `${client.describe()}, ${alarms}`);
  client.heard = [];
  say(`reset in motion: Alarm at ${show(client.state.place)}`);
  client.command('unlock');
  await client.active('unlocking', 'Idle', 5);
  await returnToZero(session);
  say('unlocked: Idle, and jogs to zero');
}

async function end(session) {
  const { client, serve, sender } = session;
  client.socket.close();
  if (await sender.stop() === null) fail('CNCjs ends by SIGTERM', 'its end within 10 s', 'none');
  const status = await serve.stop();
  if (status !== '143') fail('softcnc serve ends by SIGTERM', 'exit 143', `${status}: ${serve.printed()}`);
  await stateAtRest(session);
  say('both ended');
}

/** Rows of lines, without jogs and homing, which are of line 0: one list for each stretch. */
function stretches(rows) {
  const all = [];
  let last = 0;
  for (const row of rows) {
    if (row.line > 0 && last === 0) all.push([]);
    if (row.line > 0) all.at(-1).push(row);
    last = row.line;
  }
  return all;
}

function compareTravel({ folder }, programs) {
  const moved = stretches(readTrace(path.join(folder, 'session.csv'))).map(travelOf);
  for (const [n, { name, travel }] of programs.entries()) {
    if (!moved[n]?.every((value, k) => Math.abs(value - travel[k]) <= kTravel))
      fail(`travel of ${name}`, `${show(travel)} mm`, moved.map(show).join(', '));
    say(`${name}: X Y Z have moved ${show(moved[n])} mm, by softcnc run ${show(travel)} mm`);
  }
}

async function wholeSession(softcnc, cncjs, folder) {
  const session = await startAll(softcnc, cncjs, folder);
  try {
    for (const step of [connect, home, jog, setZero]) await step(session);
    const programs = [await runProgram(session, '03_arc', 20),
                      await runProgram(session, '08_butterfly', 30, holdAndOverride),
                      await runProgram(session, '17_drilling_cycles', 70, changeTool)];
    await resetAndUnlock(session);
    await end(session);
    compareTravel(session, programs);
  } catch (error) {
    const heard = session.client.heard.slice(-kLinesShown);
    error.message += ['\n  CNCjs has read, last:', ...heard].join('\n    ');
    throw error;
  }
}

async function main([softcnc, cncjs]) {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'softcnc-cncjs-'));
  process.on('exit', () => {
    for (const { child, ended } of processes) if (ended === null) child.kill('SIGKILL');
    fs.rmSync(folder, { recursive: true, force: true });
  });
  for (const signal of ['SIGINT', 'SIGTERM', 'SIGHUP']) process.on(signal, () => process.exit(1));
  try {
    await wholeSession(path.resolve(softcnc), path.resolve(cncjs), folder);
  } catch (error) {
    console.error(error instanceof Failure ? `FAILED: ${error.message}` : error);
    process.exit(1);
  }
  process.exit(0);
}

await main(process.argv.slice(2));
