using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Features;

/// <summary>The web between two toes: a closed leaf whose free edge is drawn in.</summary>
internal static class WebShape
{
    private const int Columns = 5;
    private const int Rows = 4;

    /// <summary>How far the free edge is drawn in half way between the toes.</summary>
    private const float Scallop = 0.28f;

    /// <summary>Share of the width by which a web keeps off the middle of each toe, where the next web begins.</summary>
    private const float Inset = 0.05f;

    /// <summary>Appends a web.</summary>
    /// <param name="builder">Where the web goes.</param>
    /// <param name="root">Where the toes part, model space, metres.</param>
    /// <param name="first">How far it reaches along the first toe.</param>
    /// <param name="second">How far it reaches along the second one.</param>
    /// <param name="thickness">Half of it, metres.</param>
    /// <param name="floor">No vertex goes below this height, metres; negative infinity for a free foot.</param>
    /// <param name="colour">Linear RGB.</param>
    public static void Append(PieceBuilder builder, Vector3 root, Vector3 first, Vector3 second, float thickness, float floor, Vector3 colour)
    {
        Vector3 up = Vec.Normalize(Vec.Cross(first - root, second - root), Vector3.UnitY);
        up = up.Y < 0f ? Vector3.Zero - up : up;
        bool turned = Vec.Dot(Vec.Cross(first - root, second - root), up) < 0f;
        int top = Layer(1f);
        int bottom = Layer(-1f);
        for (int i = 0; i + 1 < Rows; i++)
        {
            for (int k = 0; k + 1 < Columns; k++)
            {
                int a = (i * Columns) + k;
                int b = a + Columns;
                Face(top, a, b, b + 1, a + 1, turned);
                Face(bottom, a, b, b + 1, a + 1, !turned);
            }
        }

        // The rim joins both layers: along the first toe, over the free edge, back along the second, across the root.
        Span<int> rim = stackalloc int[(2 * (Rows - 1)) + (2 * (Columns - 1))];
        int n = 0;
        for (int i = 0; i + 1 < Rows; i++)
        {
            rim[n++] = i * Columns;
        }

        for (int k = 0; k + 1 < Columns; k++)
        {
            rim[n++] = ((Rows - 1) * Columns) + k;
        }

        for (int i = Rows - 1; i > 0; i--)
        {
            rim[n++] = (i * Columns) + Columns - 1;
        }

        for (int k = Columns - 1; k > 0; k--)
        {
            rim[n++] = k;
        }

        for (int q = 0; q < n; q++)
        {
            int a = rim[q];
            int b = rim[(q + 1) % n];
            if (turned)
            {
                builder.Quad(top + a, top + b, bottom + b, bottom + a);
            }
            else
            {
                builder.Quad(top + b, top + a, bottom + a, bottom + b);
            }
        }

        int Layer(float side)
        {
            int start = builder.VertexCount;
            for (int i = 0; i < Rows; i++)
            {
                // The root has a width too: a leaf that begins in a point would have faces without area.
                float s = Scalar.Lerp(0.15f, 1f, i / (Rows - 1f));
                for (int k = 0; k < Columns; k++)
                {
                    float u = Scalar.Lerp(Inset, 1f - Inset, k / (Columns - 1f));
                    float reach = s * (1f - (Scallop * s * 4f * u * (1f - u)));
                    Vector3 p = root + (Vec.Lerp(first - root, second - root, u) * reach);
                    p.Y = Math.Max(p.Y, floor + (1.05f * thickness));
                    builder.Vertex(p + (up * (side * thickness)), up * side, colour * Scalar.Lerp(1f, 0.8f, s));
                }
            }

            return start;
        }

        void Face(int layer, int a, int b, int c, int d, bool reversed)
        {
            if (reversed)
            {
                builder.Quad(layer + a, layer + d, layer + c, layer + b);
            }
            else
            {
                builder.Quad(layer + a, layer + b, layer + c, layer + d);
            }
        }
    }
}
