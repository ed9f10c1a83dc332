using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;

namespace CreatureGen.Bodies;

/// <summary>The bare leather around the nostrils, on the front of a muzzle: as broad as the muzzle where that is narrow, as on dogs and bears, and no broader than a part of the face where it is not, as on seals and hippopotamuses.</summary>
internal readonly struct NosePad
{
    // Greatest breadth of a pad against the end of the muzzle, and against the widest of the head.
    private const double OfMuzzle = 0.95;
    private const double OfFace = 0.32;

    // Height of a pad in its breadths, and greatest against the face of the muzzle above the lips.
    private const double Tall = 0.88;
    private const double OfHeight = 0.55;

    /// <summary>The part of the depth below the spine that is still above the lips.</summary>
    private const double AboveLips = 0.3;

    /// <summary>How far the middle of a pad lies below the bridge of the nose, in half heights of the pad.</summary>
    private const double BelowBridge = 0.9;

    /// <summary>What is left of a pad's breadth at its lower end, where it runs out between the lips.</summary>
    private const float Chin = 0.55f;

    /// <summary>How soft the edge is, in half breadths.</summary>
    private const float Edge = 0.14f;

    /// <summary>Where the left nostril is, half widths from its middle.</summary>
    public const float NostrilAside = 0.56f;

    /// <summary>Where the nostrils are, half heights from its middle.</summary>
    public const float NostrilAbove = 0.08f;

    /// <summary>The pad of a head.</summary>
    public NosePad(BodyShape shape)
    {
        double widest = 0;
        for (int ring = 0; ring <= StationRing.Nape; ring++)
        {
            widest = Math.Max(widest, shape.Width[ring]);
        }

        double top = shape.Top[StationRing.Nose];
        double width = Math.Min(OfMuzzle * shape.Width[StationRing.Nose], OfFace * widest);
        double height = Math.Min(Tall * width, OfHeight * (top + (AboveLips * shape.Bottom[StationRing.Nose])));
        Up = shape.Up(StationRing.Nose);
        Forward = shape.Forward(StationRing.Nose);
        HalfWidth = (float)width;
        HalfHeight = (float)height;
        Centre = shape.Centre(StationRing.Nose) + (Up * (float)(top - (BelowBridge * height)));
    }

    /// <summary>Its middle, in the plane of the first ring.</summary>
    public Vector3 Centre { get; }

    /// <summary>Unit direction in which it is high.</summary>
    public Vector3 Up { get; }

    /// <summary>Unit direction in which it looks.</summary>
    public Vector3 Forward { get; }

    /// <summary>Metres.</summary>
    public float HalfWidth { get; }

    /// <summary>Metres.</summary>
    public float HalfHeight { get; }

    /// <summary>The place of the left nostril, in the plane of the first ring.</summary>
    public Vector3 Nostril => Centre + (Up * (NostrilAbove * HalfHeight)) + (Vector3.UnitX * (NostrilAside * HalfWidth));

    /// <summary>Share of the leather's colour, 0..1, at a place of the front of the muzzle.</summary>
    public float At(Vector3 place)
    {
        float y = Vec.Dot(place - Centre, Up) / HalfHeight;
        float x = place.X / (HalfWidth * Scalar.Lerp(1f, Chin, Scalar.Clamp(-y, 0f, 1f)));
        return Scalar.Smooth((1f - (float)Math.Sqrt((x * x) + (y * y))) / Edge);
    }
}
