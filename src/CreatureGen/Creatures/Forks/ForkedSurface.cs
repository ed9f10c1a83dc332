using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Bodies;
using CreatureGen.Geometry;
using CreatureGen.Maths;

namespace CreatureGen.Creatures.Forks;

/// <summary>The surface of a body that forks into two necks, made from that of the same body with one.</summary>
/// <remarks>
/// All in front of the ring of the fork is there twice: moved along the left neck, and its mirror image. At the fork the outer half of each neck is that of the body's ring, and the inner halves of both
/// are one seam of new vertices across the body, from the back to the belly: the surface stays closed and whole.
/// </remarks>
internal sealed class ForkedSurface
{
    private const int Half = BodyGrid.Segments / 2;

    /// <summary>How far the seam stands out ahead of the ring of the fork, in half widths of the body there.</summary>
    private const float Bulge = 0.45f;

    /// <summary>Rings on either side of the fork that are smoothed, and how often.</summary>
    private const int Smoothed = 2;
    private const int Rounds = 8;

    private readonly Surface one;
    private readonly ForkCourse course;
    private readonly BodyShape shape;
    private readonly bool[] isDoubled;
    private readonly SurfaceBuilder builder = new();
    private readonly int[] left;
    private readonly int[] right;
    private readonly int[] seam = new int[Half + 1];
    private readonly int[] root = new int[BodyGrid.Segments];

    private ForkedSurface(Surface one, BodyShape shape, ForkCourse course, IReadOnlyList<bool> doubled)
    {
        this.one = one;
        this.shape = shape;
        this.course = course;
        left = new int[one.Positions.Length];
        right = new int[one.Positions.Length];
        isDoubled = new bool[one.Positions.Length];
        for (int v = 0; v < isDoubled.Length; v++)
        {
            VertexAddress address = one.Addresses[v];
            isDoubled[v] = address.Appendage >= 0 ? doubled[address.Appendage] : address.Ring < course.Ring;
        }
    }

    /// <summary>The forked surface.</summary>
    public Surface Surface { get; private set; } = null!;

    /// <summary>Where each vertex of the unforked surface is now, on the left one of both necks.</summary>
    public int[] Left => left;

    /// <summary>Where the mirror images of those are, which belong to the right one; of what is there once, the same as <see cref="Left"/>.</summary>
    public int[] Right => right;

    /// <summary>For each vertex the one of the unforked surface that it is made from.</summary>
    public int[] Source { get; private set; } = null!;

    /// <summary>Whether a vertex of the unforked surface is there twice.</summary>
    public bool IsDoubled(int vertex) => isDoubled[vertex];

    /// <summary>The vertex of the unforked surface that is there once, on the ring of the fork, for one in front of it; all others for themselves.</summary>
    public int Behind(int vertex) => isDoubled[vertex] ? root[(int)one.Addresses[vertex].Segment & (BodyGrid.Segments - 1)] : vertex;

    /// <summary>Forks a surface.</summary>
    /// <param name="one">The surface with one neck; it stays as it is.</param>
    /// <param name="shape">The sections of its body.</param>
    /// <param name="course">The way of the left neck.</param>
    /// <param name="doubled">For each appendage whether it grows in front of the fork.</param>
    public static ForkedSurface Fork(Surface one, BodyShape shape, ForkCourse course, IReadOnlyList<bool> doubled)
    {
        var forked = new ForkedSurface(one, shape, course, doubled);
        using (forked.builder)
        {
            forked.AddVertices();
            forked.AddSeam();
            forked.AddFaces();
            forked.Finish();
        }

        return forked;
    }

    private void AddVertices()
    {
        for (int v = 0; v < left.Length; v++)
        {
            VertexAddress address = one.Addresses[v];
            if (!isDoubled[v])
            {
                left[v] = right[v] = builder.Add(one.Positions[v], address);
                if (address.Region == SurfaceRegion.Body && address.Appendage < 0 && address.Ring == course.Ring)
                {
                    root[(int)address.Segment] = v;
                }

                continue;
            }

            // An ear sits on the head as the head's own skin does.
            Vector3 moved = course.Move(address.Appendage >= 0 ? ForkCourse.Rigid : address.Ring, one.Positions[v]);
            address.Sign = 1;
            left[v] = builder.Add(moved, address);
            address.Sign = -1;
            right[v] = builder.Add(Vec.Mirror(moved), address);
            builder.Pair(left[v], right[v]);
        }

        for (int v = 0; v < left.Length; v++)
        {
            if (!isDoubled[v] && one.Mirror[v] > v)
            {
                builder.Pair(left[v], left[one.Mirror[v]]);
            }
        }
    }

    private void AddSeam()
    {
        Vector3 forward = shape.Forward(course.Ring) * (Bulge * (float)shape.Width[course.Ring]);
        for (int k = 1; k < Half; k++)
        {
            int flank = root[k];
            VertexAddress address = one.Addresses[flank];
            address.Sign = 1;
            Vector3 middle = one.Positions[flank] + (forward * (float)PortableMath.Sin(PortableMath.Pi * k / Half));
            seam[k] = builder.Add(middle with { X = 0f }, address);
        }
    }

    private void AddFaces()
    {
        while (builder.Charts < one.Charts)
        {
            builder.NewChart();
        }

        for (int f = 0; f < one.Faces.Length; f++)
        {
            Face face = one.Faces[f];
            (int a, int b, int c, int d) = IsDoubled(face)
                ? (Corner(face.A), Corner(face.B), Corner(face.C), Corner(face.D))
                : (left[face.A], left[face.B], left[face.C], left[face.D]);
            builder.Quad(a, b, c, d, face.Chart, one.Texcoords[f]);
        }

        // The right neck behind the left one: each keeps the order of the faces, in which neighbours are near.
        for (int f = 0; f < one.Faces.Length; f++)
        {
            if (IsDoubled(one.Faces[f]))
            {
                AddMirrored(one.Faces[f], one.Texcoords[f]);
            }
        }
    }

    private bool IsDoubled(in Face face) => isDoubled[face.A] || isDoubled[face.B] || isDoubled[face.C] || isDoubled[face.D];

    private void AddMirrored(in Face face, in FaceTexcoords t)
    {
        ReadOnlySpan<int> mirror = builder.Mirror.Items;
        (int a, int b, int c, int d) = (mirror[Corner(face.A)], mirror[Corner(face.B)], mirror[Corner(face.C)], mirror[Corner(face.D)]);
        if (face.C == face.D)
        {
            builder.Quad(a, c, b, b, face.Chart, new FaceTexcoords(t.A, t.C, t.B, t.B));
        }
        else
        {
            builder.Quad(a, d, c, b, face.Chart, new FaceTexcoords(t.A, t.D, t.C, t.B));
        }
    }

    /// <summary>The vertex that stands on the left neck for one of the unforked surface: on the inner half of the fork's ring that of the seam.</summary>
    private int Corner(int vertex)
    {
        VertexAddress address = one.Addresses[vertex];
        bool inner = !isDoubled[vertex] && address.Region == SurfaceRegion.Body && address.Appendage < 0 && address.Ring == course.Ring && address.Segment > Half;
        return inner ? seam[BodyGrid.MirrorSegment((int)address.Segment)] : left[vertex];
    }

    private void Finish()
    {
        int[] source = new int[builder.Positions.Count];
        for (int v = 0; v < left.Length; v++)
        {
            source[left[v]] = source[right[v]] = v;
        }

        for (int k = 1; k < Half; k++)
        {
            source[seam[k]] = root[k];
        }

        Surface = Surface.From(builder, out int[] index);
        Source = new int[Surface.Positions.Length];
        for (int v = 0; v < source.Length; v++)
        {
            Source[index[v]] = source[v];
        }

        for (int v = 0; v < left.Length; v++)
        {
            (left[v], right[v]) = (index[left[v]], index[right[v]]);
        }

        Smooth();
    }

    /// <summary>Rounds off the crotch.</summary>
    private void Smooth()
    {
        var adjacency = new SurfaceAdjacency(Surface.Positions.Length, Surface.Faces);
        var round = new List<int>();
        for (int v = 0; v < Surface.Positions.Length; v++)
        {
            VertexAddress address = Surface.Addresses[v];
            if (address.Sign > 0 && address.Region == SurfaceRegion.Body && address.Appendage < 0 && Math.Abs(address.Ring - course.Ring) <= Smoothed)
            {
                round.Add(v);
            }
        }

        var next = new Vector3[round.Count];
        Vector3[] positions = Surface.Positions;
        for (int i = 0; i < Rounds; i++)
        {
            for (int k = 0; k < round.Count; k++)
            {
                Vector3 sum = Vector3.Zero;
                int count = 0;
                foreach (int n in adjacency.Of(round[k]))
                {
                    sum += positions[n];
                    count++;
                }

                next[k] = Vec.Lerp(positions[round[k]], sum / count, 0.5f);
            }

            for (int k = 0; k < round.Count; k++)
            {
                int mirror = Surface.Mirror[round[k]];
                positions[round[k]] = mirror == round[k] ? next[k] with { X = 0f } : next[k];
                positions[mirror] = mirror == round[k] ? positions[mirror] : Vec.Mirror(next[k]);
            }
        }
    }
}
