using System.Collections.Generic;
using CreatureGen.Motion.Toolkit;

namespace CreatureGen.Gltf.Models;

/// <summary>A chain that swings by itself, as the extension <c>VRMC_springBone</c> of a file describes it (VRM 1.0), in the terms of <see cref="SpringBones"/>.</summary>
/// <remarks>
/// <para>VRM steps once a frame: x′ = x + (x − x_before)(1 − drag) + dt (stiffness · rest direction + gravityPower · gravityDir), then back to the length L of the bone. The push towards rest lengthens the bone by σ = stiffness · dt / L, and
/// bringing it back takes 1 / (1 + σ) from all that goes across. At 60 frames a second that is a spring of √(60 stiffness / (L (1 + σ))) / 2π Hz without damping of its own, a drag of 60 ln((1 + σ) / (1 − drag)) per second, and
/// an acceleration of 60 gravityPower / (1 + σ) m/s². What follows here is independent of the frame rate.</para>
/// <para>Differences: bones collide along all of their length, not at their tips alone; the rest direction is that of the animated pose, not of the pose at the start; what a <c>center</c> does is not felt
/// (<see cref="SpringSettings.Inertia"/> 0); gravity has the direction of the first joint that feels any.</para>
/// </remarks>
/// <param name="Name">In the file; may be empty.</param>
/// <param name="Rig">The joints. Those of other chains, and what is animated, go along.</param>
/// <param name="Settings">How they swing, joint after joint.</param>
/// <param name="Colliders">What they stay out of.</param>
public sealed record ModelSpring(string Name, SpringRig Rig, SpringSettings Settings, IReadOnlyList<SpringCollider> Colliders);
