using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;

namespace CreatureGen.Appearance.Textures;

/// <summary>The plates of insects: rings around body and limbs, each of which ends over the one behind it, and on the body a seam along each flank between the plates of the back and those of the belly.</summary>
/// <remarks>Scattered plates are stones in a wall: on a round body each seam between them is an edge of a rough lump.</remarks>
internal sealed class Tergites
{
    // On the body a plate of an insect takes as many rings of the grid as a ring of its abdomen does, and begins where one does.
    private const float RingsOfInsects = 3f;
    private const float FirstSeam = 43f;

    // The skull is one capsule: from which ring on, and over how many, the body is divided, and the height of what is not.
    private const float Capsule = 14f;
    private const float CapsuleFade = 2.5f;
    private const float Plain = 0.8f;

    // Breadth of a seam across the body, in plates, height of a plate behind it, and where it is highest.
    private const float Seam = 0.1f;
    private const float Front = 0.58f;
    private const float Rear = 0.8f;

    // The seam along a flank: its segment and half its breadth.
    private const float Flank = 7.2f;
    private const float FlankSeam = 0.24f;

    // How far edges wave, in plates, and how deep and fine the pits are, in heights and per plate.
    private const float Wave = 0.1f;
    private const float Waves = 0.7f;
    private const float Pit = 0.12f;
    private const float Pits = 7f;

    private readonly float rings;
    private readonly PlaneNoise wave;
    private readonly PlaneNoise pits;

    /// <summary>Chooses the plates.</summary>
    /// <param name="salt">Which irregularity of edges and faces.</param>
    /// <param name="fineness">How many there are along a body where an insect has one.</param>
    public Tergites(int salt, float fineness)
    {
        rings = RingsOfInsects / fineness;
        wave = new PlaneNoise(salt);
        pits = new PlaneNoise(salt + 1);
    }

    /// <summary>Height on a limb, 0..1.</summary>
    /// <param name="place">Around and along, in plates.</param>
    public float At(Vector2 place)
    {
        float along = place.Y + (Wave * (wave.At(Waves * place.X, Waves * place.Y) - 0.5f));
        float within = along - (float)Math.Floor((double)along);
        float seam = Scalar.Smooth(Math.Min(within, 1f - within) / Seam);
        float crest = Scalar.Lerp(Front, 1f, Scalar.Smooth(within / Rear));
        return seam * (crest - (Pit * pits.At(Pits * place.X, Pits * place.Y)));
    }

    /// <summary>Height on the body, 0..1.</summary>
    /// <param name="around">Metres around, in plates.</param>
    /// <param name="ring">Ring of the body.</param>
    /// <param name="segment">Segment of the body.</param>
    public float OnBody(float around, float ring, float segment)
    {
        float plated = Scalar.Smooth((ring - Capsule) / CapsuleFade);
        if (plated <= 0f)
        {
            return Plain;
        }

        float flank = Math.Min(segment, BodyGrid.Segments - segment);
        float height = At(new Vector2(around, (ring - FirstSeam) / rings)) * Scalar.Smooth(Math.Abs(flank - Flank) / FlankSeam);
        return Scalar.Lerp(Plain, height, plated);
    }
}
