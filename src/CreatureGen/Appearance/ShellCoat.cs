using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Maths;

namespace CreatureGen.Appearance;

/// <summary>What a carapace wears: plates in the colour of the pattern, pale seams between them, and a pale rim. Wing cases keep the coat, with a dark suture.</summary>
internal sealed class ShellCoat
{
    /// <summary>Rings and segments of a plate; the grooves of the body lie on its border.</summary>
    private const float Plate = 4f;

    private const float GroovePhase = 2f;
    private const float SeamWidth = 0.34f;

    private readonly ShellBlueprint shell;
    private readonly Vector3 plate;
    private readonly Vector3 seam;

    public ShellCoat(ShellBlueprint shell, CoatPalette palette)
    {
        this.shell = shell;
        plate = Vec.Lerp(palette.Pattern, palette.Horn, 0.3f) * 0.85f;
        seam = Vec.Lerp(palette.Belly, palette.Horn, 0.45f);
    }

    /// <summary>The colour of a place of the trunk with the shell laid over <paramref name="colour"/>.</summary>
    public Vector3 Over(Vector3 colour, in SkinPlace place)
    {
        if (shell.Style == ShellStyle.None || !place.IsTrunk)
        {
            return colour;
        }

        float segment = place.Around * (float)(BodyGrid.Segments / PortableMath.Tau);
        float ring = place.Ring - shell.Ring;
        float inside = Math.Min(Math.Min(ring, shell.Rows - ring) + 0.5f, shell.Columns + 0.4f - segment);
        if (inside <= 0f)
        {
            return colour;
        }

        float covered = Scalar.Smooth(inside / 0.5f);
        if (shell.Style == ShellStyle.Elytra)
        {
            return Vec.Lerp(colour, plate * 0.5f, 0.8f * covered * Scalar.Smooth((0.45f - segment) / 0.3f));
        }

        float nearest = Math.Min(OffSeam(ring), OffSeam(segment));
        float seamed = Scalar.Smooth((SeamWidth - nearest) / 0.22f);
        float rim = Scalar.Smooth((segment - shell.Columns + 1.0f) / 0.5f);
        float shade = 1f + (0.22f * Scalar.Smooth(nearest / 1.6f));
        return Vec.Lerp(colour, Vec.Lerp(plate * shade, seam, Math.Max(0.85f * seamed, 0.6f * rim)), covered);
    }

    /// <summary>Distance from the nearest groove, in rings or segments.</summary>
    private static float OffSeam(float at)
    {
        float phase = at - GroovePhase;
        phase -= Plate * (float)Math.Floor(phase / Plate);
        return Math.Min(phase, Plate - phase);
    }
}
