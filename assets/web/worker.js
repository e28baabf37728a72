// Does work for the page: the same program, which finds itself in a worker and gives `serve`.
import start from "./shading-lab.js?VERSION";

let ready;
onmessage = ({ data }) => {
  if (data instanceof WebAssembly.Module) ready = start({ module_or_path: data });
  else ready.then(() => self.serve(data), (error) => { setTimeout(() => { throw error; }); });
};
