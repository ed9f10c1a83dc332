using System;
using System.Buffers;
using System.Collections.Generic;
using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Geometry;
using CreatureGen.Maths;
using CreatureGen.Skinning;

namespace CreatureGen.Creatures;

/// <summary>
/// What it costs to pull a point of a creature onto a neighbour, m⁴: the area that changes times the square of how far it seems to move.
/// </summary>
/// <remarks>
/// The distance to the planes of all triangles that the point has stood for (shape), the part of its weights that changes (how it bends), its colour, and whether it leaves its place in the
/// texture. The area grows with every point that is pulled onto it. What draws a viewer's attention counts as if it were larger.
/// The largest lists are borrowed from the pool and given back when it is disposed of: made anew each time they would bring about full collections of garbage.
/// </remarks>
internal sealed class ReductionCost : IDisposable
{
    /// <summary>Metres that a change of all weights counts for, per metre between the points: a joint between them bends by about this angle, radians.</summary>
    private const float Bend = 0.35f;

    /// <summary>Metres that any step counts for, per metre between the points, so that level places lose their short edges first.</summary>
    private const float Stretch = 0.03f;

    /// <summary>Metres that a change from black to white counts for, per metre of the creature's diagonal.</summary>
    private const float Contrast = 0.008f;

    /// <summary>Metres that leaving the place in the texture counts for, per metre of the creature's diagonal.</summary>
    private const float Tear = 0.02f;

    /// <summary>Metres that leaving the ground counts for, per metre of the creature's diagonal: soles stay where they stand.</summary>
    private const float Lift = 0.2f;

    /// <summary>Metres that a piece which vanishes counts for, per metre of its diagonal.</summary>
    private const float Loss = 1f;

    private readonly Vector3[] positions;
    private readonly Quadric[] quadrics;
    private readonly Quadric[] savedQuadrics;
    private readonly float[] simplificationWeight;
    private readonly SkinWeights[] weights;
    private readonly Vector3[] colours;
    private readonly float contrast;
    private readonly float tear;
    private readonly float lift;

    /// <summary>Measures the surface.</summary>
    /// <param name="mesh">What is drawn.</param>
    /// <param name="subject">The half of it that is worked on.</param>
    public ReductionCost(CreatureMesh mesh, ReductionSubject subject)
    {
        positions = subject.Positions;
        int[] pointOf = subject.PointOf;
        int[] corners = subject.Corners;
        quadrics = ArrayPool<Quadric>.Shared.Rent(positions.Length);
        savedQuadrics = ArrayPool<Quadric>.Shared.Rent(positions.Length);
        Array.Clear(quadrics, 0, positions.Length);
        for (int t = 0; t < corners.Length; t += 3)
        {
            Vector3 a = positions[corners[t]];
            Vector3 cross = Vec.Cross(positions[corners[t + 1]] - a, positions[corners[t + 2]] - a);
            Quadric quadric = Quadric.OfPlane(Vec.Normalize(cross, Vector3.UnitY), 0f, Vec.Length(cross) / 6f);
            for (int c = t; c < t + 3; c++)
            {
                quadrics[corners[c]] += quadric;
            }
        }

        weights = ArrayPool<SkinWeights>.Shared.Rent(positions.Length);
        simplificationWeight = new float[positions.Length];
        colours = new Vector3[pointOf.Length];
        for (int v = 0; v < pointOf.Length; v++)
        {
            if (pointOf[v] < 0)
            {
                continue;
            }

            weights[pointOf[v]] = mesh.Weights[v];
            float seen = mesh.SimplificationWeight is null ? 1f : mesh.SimplificationWeight[v];
            simplificationWeight[pointOf[v]] = seen * seen * seen * seen * (subject.Rim[pointOf[v]] ? 2f : 1f);

            // The root is nearer to what the eye makes of brightness.
            Vector3 c = mesh.Colours[v];
            colours[v] = new Vector3(MathF.Sqrt(Math.Max(c.X, 0f)), MathF.Sqrt(Math.Max(c.Y, 0f)), MathF.Sqrt(Math.Max(c.Z, 0f)));
        }

        float diagonal = (float)subject.Box.Diagonal;
        contrast = Contrast * diagonal;
        tear = Tear * diagonal;
        lift = Lift * diagonal;
    }

    /// <summary>The cost of a step.</summary>
    /// <param name="from">The point that goes.</param>
    /// <param name="to">The neighbour that takes its place.</param>
    /// <param name="shape">What <see cref="ShapeOf"/> says of the step.</param>
    /// <param name="pairs">For each vertex of <paramref name="from"/> the one that takes its place.</param>
    /// <param name="torn">Whether one of them leaves its place in the texture.</param>
    public float Of(int from, int to, float shape, List<(int From, int To)> pairs, bool torn)
    {
        float colour = 0;
        foreach ((int From, int To) pair in pairs)
        {
            colour += Difference(pair.From, pair.To);
        }

        return CostOf(from, to, shape, colour / pairs.Count, torn ? tear * tear : 0f);
    }

    /// <summary>The cost of a step between points with one vertex each, as <see cref="Of"/> has it.</summary>
    /// <param name="from">The point that goes.</param>
    /// <param name="to">The neighbour that takes its place.</param>
    /// <param name="shape">What <see cref="ShapeOf"/> says of the step.</param>
    /// <param name="vertex">The vertex of <paramref name="from"/>.</param>
    /// <param name="other">The vertex of <paramref name="to"/>.</param>
    public float OfPlain(int from, int to, float shape, int vertex, int other) => CostOf(from, to, shape, Difference(vertex, other), 0);

    /// <summary>How much the shape changes in a step, m⁴: worked out once for the two costs that are asked for.</summary>
    public float ShapeOf(int from, int to) => quadrics[from].At(positions[to] - positions[from]);

    /// <summary>For steps to neighbours of a point the shape, as <see cref="ShapeOf"/> has it, and a cost that <see cref="Of"/> does not fall below, whatever the rounding: that of the shape alone.</summary>
    public void Bound(int from, ReadOnlySpan<int> to, Span<float> shapes, Span<float> bounds)
    {
        Quadric quadric = quadrics[from];
        Vector3 at = positions[from];
        float factor = simplificationWeight[from];
        float stretch = quadric.Weight * (Stretch * Stretch);
        for (int i = 0; i < to.Length; i++)
        {
            Vector3 way = positions[to[i]] - at;
            float shape = quadric.At(way);
            shapes[i] = shape;
            bounds[i] = factor * (shape + (Vec.LengthSquared(way) * stretch)) * 0.99999f;
        }
    }

    /// <summary>What it costs more to pull a point out of its place in the texture.</summary>
    public float OfTear(int from) => simplificationWeight[from] * quadrics[from].Weight * tear * tear * 0.99999f;

    /// <summary>The cost of the loss of a piece.</summary>
    /// <param name="point">One of its points.</param>
    /// <param name="area">Its area, square metres.</param>
    /// <param name="diagonal">Diagonal of its box, metres.</param>
    public float OfLoss(int point, float area, float diagonal) => simplificationWeight[point] * area * Loss * diagonal * Loss * diagonal;

    /// <summary>Squared difference of two vertices' colours as the eye sees it.</summary>
    public float Difference(int vertex, int other) => Vec.LengthSquared(colours[vertex] - colours[other]);

    /// <summary>Lets a point stand for another one as well.</summary>
    public void Merge(int from, int to)
    {
        quadrics[to] += quadrics[from].About(positions[to] - positions[from]);
    }

    /// <summary>Keeps what each point stands for.</summary>
    public void Save() => Array.Copy(quadrics, savedQuadrics, positions.Length);

    /// <summary>Lets each point stand for what it stood for when that was saved.</summary>
    public void Restore() => Array.Copy(savedQuadrics, quadrics, positions.Length);

    /// <inheritdoc/>
    public void Dispose()
    {
        ArrayPool<Quadric>.Shared.Return(quadrics);
        ArrayPool<Quadric>.Shared.Return(savedQuadrics);
        ArrayPool<SkinWeights>.Shared.Return(weights);
    }

    private float CostOf(int from, int to, float shape, float colour, float torn)
    {
        float distance = Vec.LengthSquared(positions[from] - positions[to]);
        float bend = Bend * WeightChange(weights[from], weights[to]);
        float seeming = (distance * ((bend * bend) + (Stretch * Stretch))) + (colour * contrast * contrast) + torn;
        seeming += positions[from].Y == 0f && positions[to].Y != 0f ? lift * lift : 0f;
        return simplificationWeight[from] * (shape + (quadrics[from].Weight * seeming));
    }

    /// <summary>0 for equal weights, 1 for weights on other joints.</summary>
    private static float WeightChange(in SkinWeights a, in SkinWeights b)
    {
        float common = 0;
        AddCommon(ref common, a.Weights.X, a.Joint0, b);
        AddCommon(ref common, a.Weights.Y, a.Joint1, b);
        AddCommon(ref common, a.Weights.Z, a.Joint2, b);
        AddCommon(ref common, a.Weights.W, a.Joint3, b);
        return 1f - common;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void AddCommon(ref float common, float weight, int joint, in SkinWeights b)
    {
        if (weight > 0f)
        {
            common += joint == b.Joint0 ? Math.Min(weight, b.Weights.X) : 0f;
            common += joint == b.Joint1 ? Math.Min(weight, b.Weights.Y) : 0f;
            common += joint == b.Joint2 ? Math.Min(weight, b.Weights.Z) : 0f;
            common += joint == b.Joint3 ? Math.Min(weight, b.Weights.W) : 0f;
        }
    }
}
