using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Creatures;

/// <summary>How much of the light from all around reaches the skin of a creature at rest past its own limbs, head and tail: between the legs, below the belly and in the bends it is darker.</summary>
/// <remarks>
/// The capsules of the bones stand for the body: each hides a share r²/d² of the sky, by the cosine of its direction, from a place d away from its axis, as a sphere does. What is farther than some radii hides nothing.
/// The atlas of a creature has it in the red channel beside the roughness (<see cref="CreatureTextures.Roughness"/>); <see cref="CreatureTextures.AmbientOcclusionOf"/> gives it for vertices.
/// Based on: I. Quilez 2006, "Sphere ambient occlusion".
/// </remarks>
internal sealed class AmbientOcclusion
{
    /// <summary>Beyond so many radii from its axis a capsule hides nothing.</summary>
    private const float Reach = 4f;

    /// <summary>The least that is left in the deepest corner: skin scatters light.</summary>
    private const float Least = 0.2f;

    private readonly Capsule[] capsules;

    private AmbientOcclusion(Capsule[] capsules) => this.capsules = capsules;

    /// <summary>Prepares a creature.</summary>
    public static AmbientOcclusion Of(Creature creature)
    {
        var capsules = new Capsule[creature.Bones.Count];
        for (int i = 0; i < capsules.Length; i++)
        {
            CapsuleCollider bone = creature.Bones[i];
            Vector3 origin = creature.Skeleton.ModelPositions[bone.Joint];
            Quaternion rotation = creature.Skeleton.ModelRotations[bone.Joint];
            capsules[i] = new Capsule(origin + Rotation.Rotate(rotation, bone.Start), origin + Rotation.Rotate(rotation, bone.End), bone.Radius);
        }

        return new AmbientOcclusion(capsules);
    }

    /// <summary>The share of the light that reaches a place: 1 in the open, never below 0.2.</summary>
    /// <param name="position">A place of the skin, model space at rest, metres.</param>
    /// <param name="normal">Its unit normal, outwards.</param>
    public float At(Vector3 position, Vector3 normal)
    {
        float open = 1f;
        foreach (ref readonly Capsule capsule in capsules.AsSpan())
        {
            open *= 1f - capsule.Hides(position, normal);
        }

        return Least + ((1f - Least) * open);
    }

    /// <summary>The share of the light that reaches each of some places.</summary>
    /// <param name="positions">Places of the skin at rest, in units of their own.</param>
    /// <param name="normals">Their unit normals, as many.</param>
    /// <param name="scale">Metres of the model for each of those units.</param>
    public float[] OfAll(ReadOnlySpan<Vector3> positions, ReadOnlySpan<Vector3> normals, float scale)
    {
        float[] open = new float[positions.Length];
        for (int i = 0; i < open.Length; i++)
        {
            open[i] = At(positions[i] * scale, normals[i]);
        }

        return open;
    }

    private readonly struct Capsule
    {
        private readonly Vector3 start;
        private readonly Vector3 axis;
        private readonly float perAxis;
        private readonly float radius;

        public Capsule(Vector3 start, Vector3 end, float radius)
        {
            this.start = start;
            this.radius = radius;
            axis = end - start;
            float square = Vec.LengthSquared(axis);
            perAxis = square > 0f ? 1f / square : 0f;
        }

        /// <summary>The share of the light at a place that the capsule takes, 0..1.</summary>
        public float Hides(Vector3 position, Vector3 normal)
        {
            Vector3 from = position - start;
            Vector3 towards = (axis * Scalar.Clamp(Vec.Dot(from, axis) * perAxis, 0f, 1f)) - from;
            float square = Vec.LengthSquared(towards);
            float facing = Vec.Dot(towards, normal);
            if (facing <= 0f || square >= Reach * Reach * radius * radius)
            {
                return 0f;
            }

            // Within a capsule its middle tells little of where its skin is: thin ears and places where bones meet lie there.
            float share = (square < radius * radius ? square / (radius * radius) : radius * radius / square) - (1f / (Reach * Reach));
            return Math.Max(share, 0f) * facing / (float)Math.Sqrt(square);
        }
    }
}
