using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Geometry;
using CreatureGen.Maths;

namespace CreatureGen.Appearance;

/// <summary>The colour of every vertex of a creature's surface, as a function of where the vertex lies and nothing else.</summary>
/// <remarks>
/// From the ground up: countershading (dark back, pale belly), pattern, extremities in the limb colour, then head, tail, fins and wings.
/// Both sides of the body get identical colours, in whatever order the vertices are painted. Each thread needs a painter of its own.
/// </remarks>
internal sealed class CoatPainter
{
    private const float DarkestChannel = 0.003f;

    // The rings of the head over which a pattern gives way on the face, and the part of it that does: of one of broad fields, which cut a face at random, and of one of small marks.
    private const float FaceEnd = 16f;
    private const float FaceRings = 5f;
    private const float BroadOffFace = 0.75f;
    private const float SmallOffFace = 0.35f;

    // Where along a limb, 0..1, a pattern of broad fields begins to give way, over how much of it, and which part of it does; and the same of others.
    private const float BroadAlong = 0.22f;
    private const float BroadFade = 0.38f;
    private const float BroadOffLimb = 0.85f;
    private const float SmallAlong = 0.45f;
    private const float SmallFade = 0.4f;
    private const float SmallOffLimb = 0.6f;

    private readonly CoatPalette palette;
    private readonly CoatSubject subject;
    private readonly PatternField pattern;
    private readonly HeadCoat head;
    private readonly BladeCoat blades;
    private readonly TailCoat tail;
    private readonly ShellCoat shell;
    private readonly HairCoat hair;
    private readonly float strength;
    private readonly bool broad;
    private readonly float offFace;
    private readonly ValueNoise grains;
    private readonly ValueNoise tide;
    private readonly ValueNoise tone;

    /// <summary>Prepares the coat of one creature.</summary>
    public CoatPainter(CoatBlueprint coat, CoatSubject subject)
    {
        this.subject = subject;
        palette = new CoatPalette(coat);
        pattern = new PatternField(coat.PatternKind, coat.PatternScale, coat.PatternSeed, coat.Marks);
        strength = Scalar.Clamp((float)coat.PatternStrength, 0f, 1f);
        broad = coat.PatternKind is PatternKind.Patches or PatternKind.Mottle or PatternKind.Bands or PatternKind.Giraffe or PatternKind.Turing;
        offFace = broad ? BroadOffFace : SmallOffFace;
        int salt = unchecked((coat.PatternSeed * 16) + 8);
        grains = new ValueNoise(salt);
        tide = new ValueNoise(salt + 1);
        tone = new ValueNoise(salt + 2);
        head = new HeadCoat(palette, subject, coat);
        blades = new BladeCoat(palette, subject, coat.PatternSeed);
        tail = new TailCoat(palette, subject, coat.PatternSeed);
        shell = new ShellCoat(subject.Shell, palette);
        hair = new HairCoat(palette, subject);
    }

    /// <summary>The colours that the coat is made of.</summary>
    public CoatPalette Palette => palette;

    /// <summary>Linear RGB of the horn of a beak, pale enough to be seen in a dark face.</summary>
    public Vector3 BeakColour => head.BeakColour;

    /// <summary>Whether the tail ends in a fin, which is skin between rays.</summary>
    public bool HasTailFin => Anatomy.Tails.TailRays.Has(subject.Tail);

    /// <summary>Paints all vertices of a surface.</summary>
    /// <param name="addresses">Where each vertex lies.</param>
    /// <param name="positions">Rest positions, metres at scale 1.</param>
    /// <param name="mirror">The vertex on the other side.</param>
    /// <param name="normals">Unit, one per vertex.</param>
    /// <param name="colours">Receives linear RGB, 0..1, one per vertex.</param>
    public void Paint(ReadOnlySpan<VertexAddress> addresses, ReadOnlySpan<Vector3> positions, ReadOnlySpan<int> mirror, ReadOnlySpan<Vector3> normals, Span<Vector3> colours)
    {
        for (int v = 0; v < positions.Length; v++)
        {
            // A vertex of the right side takes the colour of its mirror image, which is exact even where the two addresses were rounded differently.
            int source = addresses[v].Sign < 0 ? mirror[v] : v;
            colours[v] = source < v ? colours[source] : At(addresses[source], positions[source], normals[source]);
        }
    }

    /// <summary>Linear RGB, 0..1, of one vertex.</summary>
    /// <param name="address">Where it lies.</param>
    /// <param name="position">Rest position, model space, metres at scale 1.</param>
    /// <param name="normal">Unit normal.</param>
    public Vector3 At(in VertexAddress address, Vector3 position, Vector3 normal)
    {
        var place = new SkinPlace(address, position, normal, subject.Body);
        return Marked(place, Undercoat(place, TonesAt(place), pattern.At(PatternAt(place))), Grain(place));
    }

    /// <summary>The colours of a place between which the pattern goes, linearly: without and with the full pattern. They change slowly over the surface; the pattern and markings do not.</summary>
    public CoatRange RangeAt(in VertexAddress address, Vector3 position, Vector3 normal)
    {
        var place = new SkinPlace(address, position, normal, subject.Body);
        Tones tones = TonesAt(place);
        Vector3 plain = Undercoat(place, tones, 0f);
        Vector3 patterned = Undercoat(place, tones, 1f);
        float grain = Grain(place);
        return new CoatRange(plain, patterned, grain, Marked(place, plain, grain), Marked(place, patterned, grain), PatternAt(place));
    }

    /// <summary>Share of the full pattern at a place, 0..1.</summary>
    public float PatternFraction(in PatternPlace place) => pattern.At(place);

    /// <summary>Lays what a region wears of its own (markings of the head, rays of a fin, feathers of a wing) over the colour of the coat below it. Not for hooves, which need a normal.</summary>
    /// <param name="address">Where it lies.</param>
    /// <param name="position">Rest position, model space, metres at scale 1.</param>
    /// <param name="undercoat">Linear RGB, with the pattern.</param>
    /// <param name="grain">Factor on the result.</param>
    public Vector3 MarkedAt(in VertexAddress address, Vector3 position, Vector3 undercoat, float grain) =>
        Marked(new SkinPlace(address, position, Vector3.UnitY, subject.Body), undercoat, grain);

    private Vector3 Marked(in SkinPlace place, Vector3 undercoat, float grain)
    {
        Vector3 colour = place.Region switch
        {
            SurfaceRegion.Mouth => palette.MouthInside,
            SurfaceRegion.Hoof => palette.Claw * Scalar.Lerp(1.15f, 0.8f, Scalar.Smooth(place.Normal.Y + 0.5f)),
            SurfaceRegion.EarInside => palette.EarInside,
            _ => Skin(place, undercoat),
        };
        colour *= grain;
        return new Vector3(Limit(colour.X), Limit(colour.Y), Limit(colour.Z));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private PatternPlace PatternAt(in SkinPlace place) => new(place.Position, Run(place), place.Around);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private float Grain(in SkinPlace place) => 0.94f + (0.12f * grains.At(place.Position * 9f));

    private Vector3 Skin(in SkinPlace place, Vector3 undercoat)
    {
        if (place.IsTrunk)
        {
            return hair.Over(head.Over(shell.Over(tail.Over(undercoat, place), place), place), place);
        }

        return place.IsLimb ? Limb(undercoat, place) : blades.Over(undercoat, place);
    }

    private Tones TonesAt(in SkinPlace place)
    {
        float ventral = Countershade(place) + (0.10f * (tide.At(place.Position * 5f) - 0.5f));
        float belly = Scalar.Smooth((ventral - 0.52f) / 0.30f);
        float back = 0.62f * Scalar.Smooth((0.26f - ventral) / 0.26f);

        // Broad, faint drifts of tone keep a plain skin alive.
        float drift = tone.At(place.Position * 2.3f) - 0.5f;
        Vector3 colour = Vec.Lerp(palette.Base, drift > 0f ? palette.Back : palette.Belly, 0.34f * Math.Abs(drift));
        return new Tones(Vec.Lerp(colour, palette.Back, back), belly);
    }

    private Vector3 Undercoat(in SkinPlace place, in Tones tones, float patternFraction)
    {
        float mask = patternFraction * strength * (1f - (0.75f * tones.Belly));
        if (place.IsLimb)
        {
            mask *= broad ? 1f - (BroadOffLimb * Scalar.Smooth((place.Along - BroadAlong) / BroadFade)) : 1f - (SmallOffLimb * Scalar.Smooth((place.Along - SmallAlong) / SmallFade));
        }
        else if (place.IsTrunk)
        {
            mask *= 1f - (offFace * Scalar.Smooth((FaceEnd - place.Ring) / FaceRings));
        }

        Vector3 colour = Vec.Lerp(tones.Back, palette.Pattern, mask);
        return Vec.Lerp(colour, palette.Belly, 0.9f * tones.Belly);
    }

    // 0 where the back is to 1 where the belly is; limbs and blades leave the shade of their root for one of their own.
    private float Countershade(in SkinPlace place)
    {
        if (place.IsTrunk)
        {
            return place.Ventral * tail.ShadeAt(place);
        }

        if (place.IsLimb)
        {
            float inside = Scalar.Smooth(-place.Normal.X);
            float inner = 0.16f * inside * (1f - place.Along);

            // The belly's shade runs out on the inner side of a thigh; on the rear of one it would be a pale patch for who is behind it.
            return Scalar.Lerp(place.Ventral, 0.35f + (0.12f * place.Along) + inner, Scalar.Smooth(place.Along / Scalar.Lerp(0.1f, 0.26f, inside)));
        }

        return Scalar.Lerp(place.Ventral, 0.45f, Scalar.Smooth(place.Along / 0.22f));
    }

    // What stripes count: metres along the body, and down a limb so that they ring it.
    private float Run(in SkinPlace place)
    {
        if (!place.IsLimb)
        {
            return place.Arc;
        }

        float drop = (float)Bodies.BodyShape.At(subject.Body.Y, place.Ring) - place.Position.Y;
        float reach = (float)Math.Sqrt((place.Position.X * place.Position.X) + (drop * drop));
        return place.Arc + (reach * Scalar.Smooth(place.Along / 0.3f));
    }

    private Vector3 Limb(Vector3 undercoat, in SkinPlace place)
    {
        float edge = 0.14f * (tide.At(place.Position * 11f) - 0.5f);
        float fraction = place.Region == SurfaceRegion.Toe ? 0.85f : 0.8f * Scalar.Smooth((place.Along + edge - 0.27f) / 0.56f);

        // Evenly to the eye: in linear light a pale foot shines through a dark leg at its first tenths, and the rest is a sock.
        Vector3 seen = Vec.Lerp(Root(undercoat), Root(palette.Limb), fraction);
        return seen * seen;
    }

    private static Vector3 Root(Vector3 colour) => new((float)Math.Sqrt(colour.X), (float)Math.Sqrt(colour.Y), (float)Math.Sqrt(colour.Z));

    private static float Limit(float channel) => Scalar.Clamp(channel, DarkestChannel, 1f);

    /// <summary>What lies below a pattern: asked for once for the two ends of its range.</summary>
    /// <param name="Back">Linear RGB with the back's shade.</param>
    /// <param name="Belly">How far the place is on the belly, 0..1.</param>
    private readonly record struct Tones(Vector3 Back, float Belly);
}
