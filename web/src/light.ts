/**
 * Surfaces in daylight. The light is found at vertices, not at pixels: shapes are fine enough for that, and where
 * pixels are drawn by the processor it saves much of a frame.
 */
import { Color, ShaderMaterial } from "three";

// From above the sky, from the front and the left the sun; what looks down gets the light of the ground.
const light = /* glsl */ `
float light(vec3 normal) {
  vec3 n = normalize(normal);
  float sky = mix(0.7, 0.44, 0.5 + 0.5 * n.z);
  return sky + 0.36 * max(dot(n, normalize(vec3(0.4, -0.5, -1.0))), 0.0);
}`;

/** Painted by the colours of the vertices. */
export function paintedMaterial(): ShaderMaterial {
  return new ShaderMaterial({
    vertexColors: true,
    vertexShader: /* glsl */ `
      ${light}
      varying vec3 shade;
      void main() {
        shade = color.rgb * light(mat3(modelMatrix) * normal);
        gl_Position = projectionMatrix * (modelViewMatrix * vec4(position, 1.0));
      }`,
    fragmentShader: /* glsl */ `
      varying vec3 shade;
      void main() { gl_FragColor = vec4(shade, 1.0); }`,
  });
}

/** Of one colour, which one sees through. */
export function ghostMaterial(opacity: number): ShaderMaterial & { uniforms: { ghost: { value: Color } } } {
  const material = new ShaderMaterial({
    transparent: true,
    depthWrite: false,
    // Where the ghost lies on the aircraft itself, the aircraft is seen.
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 2,
    uniforms: { ghost: { value: new Color() }, opacity: { value: opacity } },
    vertexShader: /* glsl */ `
      ${light}
      uniform vec3 ghost;
      varying vec3 shade;
      void main() {
        shade = ghost * light(mat3(modelMatrix) * normal);
        gl_Position = projectionMatrix * (modelViewMatrix * vec4(position, 1.0));
      }`,
    fragmentShader: /* glsl */ `
      uniform float opacity;
      varying vec3 shade;
      void main() { gl_FragColor = vec4(shade, opacity); }`,
  });
  return material as ReturnType<typeof ghostMaterial>;
}
