using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Rigging;
using CreatureGen.Skinning;

namespace CreatureGen.Motion.Winged;

/// <summary>The left side of a body at rest, as seen from there: how far out its skin is at each height and length, without legs, and with those wings that are already folded onto it.</summary>
internal sealed class Flank
{
    private const int Columns = 80;

    /// <summary>Most of a corner that wings move for its skin to be the body's.</summary>
    private const float MaxFraction = 0.02f;

    private readonly float[] outward;
    private readonly int rows;
    private readonly float cell;
    private readonly float bottom;
    private readonly float back;
    private readonly float[] backs = new float[Columns];
    private bool changed = true;

    /// <summary>Takes a creature.</summary>
    public Flank(MotionSubject subject)
    {
        CreatureMesh mesh = subject.Mesh;
        ReadOnlySpan<Vector3> positions = mesh.Positions;
        bool[] trunk = TrunkJoints(subject.Skeleton);
        bool[] body = new bool[positions.Length];
        var min = new Vector3(float.MaxValue);
        var max = new Vector3(float.MinValue);
        for (int v = 0; v < body.Length; v++)
        {
            body[v] = IsBody(trunk, mesh.Weights[v]);
            if (body[v])
            {
                min = Vec.Min(min, positions[v]);
                max = Vec.Max(max, positions[v]);
            }
        }

        bottom = min.Y;
        back = min.Z;
        cell = Math.Max((max.Z - back) / Columns, 1e-6f);
        rows = Math.Max(1, (int)Math.Ceiling((max.Y - bottom) / cell));
        outward = new float[rows * Columns];
        ReadOnlySpan<int> triangles = mesh.Triangles;
        for (int t = 0; t < triangles.Length; t += 3)
        {
            if (body[triangles[t]] && body[triangles[t + 1]] && body[triangles[t + 2]])
            {
                Draw(positions[triangles[t]], positions[triangles[t + 1]], positions[triangles[t + 2]]);
            }
        }
    }

    /// <summary>How far a point is off the skin, negative within the body; whether the body is seen there at all: where not, most of a wing, its slope is not asked for.</summary>
    public bool TryDistance(Vector3 point, out double distance)
    {
        int column = (int)Math.Floor((point.Z - back) / cell);
        int row = (int)Math.Floor((point.Y - bottom) / cell);
        float here = At(row, column);
        if (!(here > 0f))
        {
            distance = 0;
            return false;
        }

        float high = (At(row + 1, column) - At(row - 1, column)) / (2f * cell);
        float along = (At(row, column + 1) - At(row, column - 1)) / (2f * cell);
        distance = (point.X - here) / Math.Sqrt(1.0 + (high * high) + (along * along));
        return true;
    }

    /// <summary>Height of the back at a length, metres; infinite where there is no body.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float Back(float z)
    {
        int column = (int)Math.Floor((z - back) / cell);
        if (changed)
        {
            FindBacks();
        }

        return (uint)column < Columns ? backs[column] : float.PositiveInfinity;
    }

    /// <summary>Adds a triangle: what is outermost over the middle of each cell is kept.</summary>
    public void Draw(Vector3 a, Vector3 b, Vector3 c)
    {
        float area = ((b.Y - c.Y) * (a.Z - c.Z)) + ((c.Z - b.Z) * (a.Y - c.Y));
        if (Math.Abs(area) < 1e-12f)
        {
            return;
        }

        changed = true;
        Vector3 min = Vec.Min(a, Vec.Min(b, c));
        Vector3 max = Vec.Max(a, Vec.Max(b, c));
        for (int row = Cell(min.Y - bottom, rows); row <= Cell(max.Y - bottom, rows); row++)
        {
            for (int column = Cell(min.Z - back, Columns); column <= Cell(max.Z - back, Columns); column++)
            {
                float y = bottom + ((row + 0.5f) * cell);
                float z = back + ((column + 0.5f) * cell);
                float first = (((b.Y - c.Y) * (z - c.Z)) + ((c.Z - b.Z) * (y - c.Y))) / area;
                float second = (((c.Y - a.Y) * (z - c.Z)) + ((a.Z - c.Z) * (y - c.Y))) / area;
                if (first >= 0f && second >= 0f && first + second <= 1f)
                {
                    ref float kept = ref outward[(row * Columns) + column];
                    kept = Math.Max(kept, (a.X * first) + (b.X * second) + (c.X * (1f - first - second)));
                }
            }
        }
    }

    private void FindBacks()
    {
        changed = false;
        for (int column = 0; column < Columns; column++)
        {
            int row = rows - 1;
            while (row >= 0 && outward[(row * Columns) + column] <= 0f)
            {
                row--;
            }

            backs[column] = row < 0 ? float.PositiveInfinity : bottom + ((row + 1) * cell);
        }
    }

    private static bool[] TrunkJoints(Skeleton skeleton)
    {
        bool[] trunk = new bool[skeleton.Count];
        for (int j = 0; j < trunk.Length; j++)
        {
            trunk[j] = skeleton.Joints[j].Role is JointRole.Pelvis or JointRole.Spine or JointRole.Chest or JointRole.Neck or JointRole.Tail or JointRole.Girdle or JointRole.Body;
        }

        return trunk;
    }

    private static bool IsBody(bool[] trunk, in SkinWeights weights) =>
        (trunk[weights.Joint0] ? 0f : weights.Weights.X) + (trunk[weights.Joint1] ? 0f : weights.Weights.Y)
        + (trunk[weights.Joint2] ? 0f : weights.Weights.Z) + (trunk[weights.Joint3] ? 0f : weights.Weights.W) < MaxFraction;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private float At(int row, int column) => (uint)row < (uint)rows && (uint)column < Columns ? outward[(row * Columns) + column] : 0f;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private int Cell(float offset, int count) => Math.Min(count - 1, Math.Max(0, (int)(offset / cell)));
}
