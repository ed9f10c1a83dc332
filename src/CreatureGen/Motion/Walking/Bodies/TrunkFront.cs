using System;
using System.Numerics;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Walking.Bodies;

/// <summary>The front of a trunk on many pairs of legs, which acts raise off the ground with its feet while the others stand, as centipedes and caterpillars do.</summary>
/// <param name="Slot">The joint of the trunk behind it, as a place among the trunk's.</param>
/// <param name="Joints">Number of joints that bend for it; 0 of bodies that raise nothing.</param>
internal readonly record struct TrunkFront(int Slot, int Joints)
{
    /// <summary>Pairs of legs that it raises at least, and that stand behind it at least, and no fewer than it raises: a body on fewer rears up on its hind legs.</summary>
    private const int Least = 2;
    private const int Standing = 3;

    /// <summary>Whether there is one.</summary>
    public bool Exists => Joints > 0;

    /// <summary>The front of a trunk.</summary>
    /// <param name="legs">That carry it.</param>
    /// <param name="rows">Number of pairs.</param>
    /// <param name="foreSlot">The joint of the foremost pair.</param>
    public static TrunkFront Of(LegRig[] legs, int rows, int foreSlot)
    {
        for (int slot = 0; slot < foreSlot; slot++)
        {
            int feet = 0;
            foreach (LegRig leg in legs)
            {
                feet += leg.TrunkSlot > slot ? 1 : 0;
            }

            int pairs = feet / 2;
            if (pairs <= Math.Min(rows / 2, rows - Standing))
            {
                return pairs >= Least ? new TrunkFront(slot, foreSlot - slot) : default;
            }
        }

        return default;
    }

    /// <summary>Whether a leg hangs on it.</summary>
    public bool Carries(LegRig leg) => Joints > 0 && leg.TrunkSlot > Slot;

    /// <summary>How far each of its joints bends for what an act asks, besides what it is bent by already.</summary>
    /// <param name="bends">How far a trunk bends.</param>
    /// <param name="slots">Number of joints from the pelvis on that share a bend of the trunk.</param>
    /// <param name="bend">By what the trunk is bent: pitch, yaw and roll, radians.</param>
    /// <param name="asked">The same of the front alone.</param>
    public Vector3 Within(TrunkBends bends, int slots, Vector3 bend, Vector3 asked)
    {
        float shares = (float)slots / Math.Max(Joints, 1);
        return (bends.Within(bend + (asked * shares)) - bend) / Math.Max(slots, 1);
    }
}
