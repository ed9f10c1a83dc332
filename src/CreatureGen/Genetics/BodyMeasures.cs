using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Genetics;

/// <summary>The body of a grown creature in a few lengths, measured on its surface and its skeleton in rest pose. Metres.</summary>
/// <param name="Size">Side of a cube that holds as much as the body: what lengths are compared with, so that creatures of all sizes compare.</param>
/// <param name="Length">From the foremost to the hindmost point.</param>
/// <param name="Height">From the lowest to the highest point.</param>
/// <param name="Width">From the leftmost to the rightmost point.</param>
/// <param name="Head">Bones of the head and its jaw.</param>
/// <param name="Neck">Bones of the neck together.</param>
/// <param name="Trunk">Bones of pelvis, spine and chest together.</param>
/// <param name="Tail">Bones of the tail together.</param>
/// <param name="Leg">Height of the highest hip of a standing leg; 0 without any.</param>
/// <param name="Wing">Bones of the longest wing or paired fin together; 0 without any.</param>
/// <param name="LegPairs">Pairs of legs that stand.</param>
public sealed record BodyMeasures(double Size, double Length, double Height, double Width, double Head, double Neck, double Trunk, double Tail, double Leg, double Wing, int LegPairs)
{
    /// <summary>Measures a creature.</summary>
    /// <exception cref="ArgumentNullException">There is no creature.</exception>
    public static BodyMeasures Of(Creature creature)
    {
        _ = creature ?? throw new ArgumentNullException(nameof(creature));
        Vector3 low = creature.Mesh.Positions[0];
        Vector3 high = low;
        foreach (Vector3 position in creature.Mesh.Positions)
        {
            low = Vec.Min(low, position);
            high = Vec.Max(high, position);
        }

        double head = 0, neck = 0, trunk = 0, tail = 0;
        foreach (Joint joint in creature.Skeleton.Joints)
        {
            head = joint.Role is JointRole.Head or JointRole.Jaw ? Math.Max(head, joint.Length) : head;
            neck += joint.Role == JointRole.Neck ? joint.Length : 0;
            trunk += joint.Role is JointRole.Pelvis or JointRole.Spine or JointRole.Chest ? joint.Length : 0;
            tail += joint.Role == JointRole.Tail ? joint.Length : 0;
        }

        double leg = 0, wing = 0;
        int standing = 0;
        foreach (LimbChain limb in creature.Limbs)
        {
            if (limb.Kind == LimbKind.Leg && limb.Stands)
            {
                standing += limb.Side == Side.Left ? 1 : 0;
                leg = Math.Max(leg, creature.Skeleton.Joints[limb.Joints[1]].ModelPosition.Y);
            }
            else if (limb.Kind is LimbKind.Wing or LimbKind.InsectWing or LimbKind.Pectoral)
            {
                wing = Math.Max(wing, Sum(limb.RestLengths));
            }
        }

        double size = PortableMath.Pow(creature.Mass.Volume, 1 / 3.0);
        return new BodyMeasures(size, high.Z - low.Z, high.Y - low.Y, high.X - low.X, head, neck, trunk, tail, leg, wing, standing);
    }

    private static double Sum(IReadOnlyList<float> lengths)
    {
        double sum = 0;
        foreach (float length in lengths)
        {
            sum += length;
        }

        return sum;
    }
}
