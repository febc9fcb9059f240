// A jsPsych trial that is a whole session: the page that `impetus publish` wrote, over the window, until
// its last page. Afterwards the trial's data say how it ended, and hold what is to be collected.

import {ParameterType} from 'jspsych';

/** Runs a published study. The site's folder must lie at the experiment's own origin. */
export default class ImpetusPlugin {
  static info = {
    name: 'impetus',
    version: '0.1.0',
    parameters: {
      /** Link of the folder that `impetus publish` wrote, such as "site/". */
      site: {type: ParameterType.STRING, default: undefined},
      /** The participant's code; null: the site draws one. */
      participant: {type: ParameterType.STRING, default: null},
      /** Seed of the plan of trials. */
      seed: {type: ParameterType.INT, default: 1},
    },
    data: {
      /** "finished", "declined", "quit", or "failed": the browser could not show it. */
      ending: {type: ParameterType.STRING},
      /** The code under which the session goes. */
      participant: {type: ParameterType.STRING},
      /** Files for `impetus collect`: name, and lines of JSON, whose numbers have 64 bits: keep them as
          text. A session that was left and went on has several; a site that sends its trials to a drop or
          server itself has none. */
      files: {type: ParameterType.COMPLEX, array: true, nested: {
        name: {type: ParameterType.STRING},
        lines: {type: ParameterType.STRING},
      }},
    },
  };

  constructor(jsPsych) {
    this.jsPsych = jsPsych;
  }

  trial(display, trial) {
    const frame = this.show(display, trial);
    const hear = (event) => {
      if (event.source !== frame.contentWindow || event.origin !== location.origin || !event.data.impetus) return;
      removeEventListener('message', hear);
      display.replaceChildren();
      this.jsPsych.finishTrial(event.data.impetus);
    };
    addEventListener('message', hear);
  }

  /** "data-only" tells what a session that was finished would; "visual" shows its first page, too. */
  simulate(trial, mode, options, loaded) {
    const data = this.jsPsych.pluginAPI.mergeSimulationData({ending: 'finished',
      participant: trial.participant ?? this.jsPsych.randomization.randomID(8), files: [],
      rt: this.jsPsych.randomization.sampleExGaussian(600000, 60000, 1 / 60000, true)}, options);
    if (mode === 'data-only') {
      loaded();
      return this.jsPsych.finishTrial(data);
    }
    const display = this.jsPsych.getDisplayElement();
    this.show(display, trial).addEventListener('load', () => {
      loaded();
      this.jsPsych.pluginAPI.setTimeout(() => {
        display.replaceChildren();
        this.jsPsych.finishTrial(data);
      }, 1000);
    });
  }

  show(display, trial) {
    const link = new URL('index.html', new URL(trial.site.replace(/\/?$/, '/'), location.href));
    link.searchParams.set('seed', trial.seed);
    if (trial.participant !== null) link.searchParams.set('participant', trial.participant);
    const frame = document.createElement('iframe');
    Object.assign(frame, {src: link, allow: 'fullscreen'});
    Object.assign(frame.style, {position: 'fixed', inset: 0, width: '100%', height: '100%', border: 0});
    frame.addEventListener('load', () => frame.contentWindow.focus());
    display.replaceChildren(frame);
    return frame;
  }
}
