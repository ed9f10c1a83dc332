using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;

namespace CreatureGen.Appearance.Textures;

/// <summary>The fine relief of a skin as a height over its texture chart. Everything in metres at scale 1. Each thread needs its own.</summary>
/// <remarks>Rows of scales and feathers run around the chart (along u) and overlap along v, from head to tail or from root to tip.</remarks>
internal sealed class SkinRelief
{
    /// <summary>Where the edge of a scale or feather ends and begins, from its middle.</summary>
    private const float OuterEdge = 0.92f, InnerEdge = 0.82f;

    /// <summary>Length of a feather in sizes of a cover, and where its soft edge begins: long ones with hard edges are plates of armour.</summary>
    private const float FeatherLength = 1.25f, FeatherInnerEdge = 0.64f;

    /// <summary>How much finer scales and feathers are on limbs than on the body, which is so much thicker.</summary>
    private const float FinerOnLimbs = 1.5f;

    private readonly SkinCover cover;
    private readonly float perSize;
    private readonly float perRow;
    private readonly PlaneNoise broad;
    private readonly PlaneNoise coarse;
    private readonly PlaneNoise fine;
    private readonly Tergites tergites;

    /// <summary>Chooses the relief.</summary>
    /// <param name="cover">What it is made of.</param>
    /// <param name="size">Length of one scale, feather, plate or tuft, metres.</param>
    /// <param name="salt">Which one of its kind.</param>
    /// <param name="fineness">How many plates there are where an insect has one.</param>
    public SkinRelief(SkinCover cover, float size, int salt, float fineness = 1f)
    {
        this.cover = cover;
        size = cover == SkinCover.Feathers ? FeatherLength * size : cover == SkinCover.Plates ? size / fineness : size;
        perSize = 1f / size;
        perRow = 1.15f * perSize;
        broad = new PlaneNoise(salt);
        coarse = new PlaneNoise(salt + 1);
        fine = new PlaneNoise(salt + 2);
        tergites = new Tergites(salt, fineness);
        Amplitude = size * cover switch
        {
            SkinCover.Scales => 0.22f,
            SkinCover.Feathers => 0.16f,
            SkinCover.Plates => 0.16f,
            SkinCover.Fur => 0.2f,
            _ => 0.12f,
        };
        Shade = cover switch
        {
            SkinCover.Scales or SkinCover.Plates => 0.34f,
            SkinCover.Feathers => 0.3f,
            SkinCover.Fur => 0.3f,
            _ => 0.14f,
        };
        Roughness = cover switch
        {
            SkinCover.Scales => 0.55f,
            SkinCover.Plates => 0.38f,
            SkinCover.Feathers => 0.78f,
            SkinCover.Fur => 0.92f,
            _ => 0.6f,
        };
    }

    /// <summary>Whether it is of plates.</summary>
    public bool IsPlated => cover == SkinCover.Plates;

    /// <summary>Height of the relief between its lowest and its highest place, metres.</summary>
    public float Amplitude { get; }

    /// <summary>How much of the colour the relief changes: dark in the gaps, light on the crests.</summary>
    public float Shade { get; }

    /// <summary>Roughness of the skin between 0 and 1.</summary>
    public float Roughness { get; }

    /// <summary>Height at a place of a chart of a limb, 0..1 of the amplitude.</summary>
    /// <param name="place">Metres around and along.</param>
    public float OnLimb(Vector2 place) => At(cover is SkinCover.Scales or SkinCover.Feathers ? FinerOnLimbs * place : place);

    /// <summary>Height at a place of a chart, 0..1 of the amplitude.</summary>
    /// <param name="place">Metres around and along.</param>
    public float At(Vector2 place) => cover switch
    {
        SkinCover.Scales => Overlapping(place, shaft: 0f),
        SkinCover.Feathers => Overlapping(place, shaft: 0.18f),
        SkinCover.Plates => tergites.At(perSize * place),
        SkinCover.Fur => Fur(place),
        _ => Wrinkles(place),
    };

    /// <summary>Height at a place of a chart of the body, 0..1 of the amplitude: plates there follow its rings.</summary>
    /// <param name="place">Metres around and along.</param>
    /// <param name="ring">Ring of the body.</param>
    /// <param name="segment">Segment of the body.</param>
    public float OnBody(Vector2 place, float ring, float segment) => IsPlated ? tergites.OnBody(perSize * place.X, ring, segment) : At(place);

    /// <summary>Two rows of rounded tongues may cover a place; the one further forward lies on top.</summary>
    private float Overlapping(Vector2 place, float shaft)
    {
        float v = place.Y * perRow;
        float u = place.X * perSize;
        int row = (int)Math.Floor((double)v);
        float above = Tongue(u, v, row - 1, shaft, out float edge);
        return edge > 0.5f ? above : Tongue(u, v, row, shaft, out _);
    }

    /// <summary>Height of a tongue of a row, and its edge: 1 on it, 0 beside it. A tongue is one and a half rows long: its rounded end lies over the next row.</summary>
    private static float Tongue(float u, float v, int row, float shaft, out float edge)
    {
        float across = u + (0.5f * (row & 1));
        float fu = across - (float)Math.Floor((double)across) - 0.5f;
        float fv = (v - row) * (1f / 1.5f);
        float beyond = Math.Max(fv - 0.62f, 0f);
        float squared = (3.0625f * fu * fu) + (6.5f * beyond * beyond);
        float inner = shaft == 0f ? InnerEdge : FeatherInnerEdge;
        edge = squared >= OuterEdge * OuterEdge ? 0f
            : squared <= inner * inner ? 1f
            : Scalar.Smooth((OuterEdge - (float)Math.Sqrt(squared)) / (OuterEdge - inner));
        float rib = shaft == 0f ? 0f : shaft * Math.Max(0f, 1f - (400f * fu * fu));
        return edge * (((0.45f + (0.5f * fv)) * (1f - (1.6f * fu * fu))) - rib);
    }

    /// <summary>Hair lies along v: noise that is long in v, shifted by a slower noise so that it waves.</summary>
    private float Fur(Vector2 place)
    {
        float u = place.X * perSize;
        float v = place.Y * perSize;
        float wave = broad.At(0.9f * u, 0.7f * v);
        float tufts = coarse.At((2.6f * u) + wave, 0.42f * v);
        float hairs = fine.At((6f * u) + (2f * wave), 0.9f * v);
        return (0.55f * tufts) + (0.45f * hairs);
    }

    private float Wrinkles(Vector2 place)
    {
        float u = place.X * perSize;
        float v = place.Y * perSize;

        // Two lattices at an angle to each other: the folds of one alone run along its rows and columns, like a maze.
        float fold = (0.55f * broad.At(1.1f * u, 1.9f * v)) + (0.45f * fine.At((1.5f * u) + (1.9f * v), (1.6f * v) - (1.3f * u)));
        float ridge = Math.Max(0f, 1f - Math.Abs(3f * (fold - 0.5f)));
        float pores = coarse.At(5f * u, 5f * v);
        return 1f - (0.7f * ridge * ridge * ridge) - (0.15f * pores);
    }
}
