using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Features;

/// <summary>Where a tongue lies: the middle line between the two halves of the lower lip, from near the lip corners to shortly behind the front of the jaw.</summary>
internal readonly struct MouthFloor
{
    /// <summary>Where the tongue begins, points of the lip in front of its corner.</summary>
    private const float Root = 1.2f;

    private readonly Vector3[] lip;
    private readonly float front;

    /// <summary>The floor between the halves of a lip.</summary>
    /// <param name="lip">Left half of the lower lip from its corner to the ring of the nose, at least 3 points.</param>
    /// <param name="up">Unit direction from the floor to the palate.</param>
    /// <param name="reach">How far forward the tongue reaches, as a share of the lip.</param>
    /// <param name="depth">Depth of the head from the lip to its underside, metres.</param>
    public MouthFloor(Vector3[] lip, Vector3 up, float reach, float depth)
    {
        this.lip = lip;
        front = (lip.Length - 1) * reach;
        Up = up;
        Thickness = 0.30f * depth;
    }

    /// <summary>Unit direction from the floor to the palate.</summary>
    public Vector3 Up { get; }

    /// <summary>Half thickness of a tongue, metres.</summary>
    public float Thickness { get; }

    /// <summary>A point of the middle line, 0 at the root of the tongue and 1 at its tip, and half the width of the mouth there.</summary>
    public Vector3 At(float along, out float halfWidth)
    {
        float k = Scalar.Lerp(Math.Min(Root, front - 0.5f), front, along);
        int i = Math.Min(Math.Max((int)k, 0), lip.Length - 2);
        Vector3 p = Vec.Lerp(lip[i], lip[i + 1], k - i);
        halfWidth = Math.Abs(p.X);
        return new Vector3(0f, p.Y, p.Z);
    }
}
