using System;
using System.Collections.Generic;
using System.Numerics;

namespace CreatureGen.Motion.Metrics.Courses;

/// <summary>A ground drawn as a line along +Z, the same all across: level floors, ramps, risers and gaps, one after the other. A mesh that is there from above, and risers from the side of the lower floor.</summary>
internal sealed class GroundProfile
{
    private readonly List<Vector3> positions = new();
    private readonly List<int> triangles = new();
    private readonly float halfWidth;

    /// <summary>Begins on level ground.</summary>
    /// <param name="halfWidth">Metres to the left and right of the axis.</param>
    /// <param name="start">Where the ground begins, z in metres.</param>
    public GroundProfile(float halfWidth, float start)
    {
        this.halfWidth = halfWidth;
        Z = start;
    }

    /// <summary>Where the line has come to, metres.</summary>
    public float Z { get; private set; }

    /// <summary>Its height there, metres.</summary>
    public float Y { get; private set; }

    /// <summary>Goes on level ground.</summary>
    /// <param name="length">Metres.</param>
    public GroundProfile Floor(float length) => Ramp(length, 0f);

    /// <summary>Goes up or down an even slope.</summary>
    /// <param name="length">Metres along Z.</param>
    /// <param name="rise">Metres; negative goes down.</param>
    public GroundProfile Ramp(float length, float rise)
    {
        Surface(new Vector3(0f, rise, length));
        return this;
    }

    /// <summary>Steps up or down.</summary>
    /// <param name="rise">Metres; negative goes down.</param>
    public GroundProfile Riser(float rise)
    {
        Surface(new Vector3(0f, rise, 0f));
        return this;
    }

    /// <summary>Leaves out the ground.</summary>
    /// <param name="length">Metres along Z.</param>
    public GroundProfile Gap(float length)
    {
        Z += length;
        return this;
    }

    /// <summary>Steps up or down, each with its tread behind its riser.</summary>
    /// <param name="steps">How many.</param>
    /// <param name="tread">Metres along Z.</param>
    /// <param name="rise">Metres; negative goes down.</param>
    public GroundProfile Flight(int steps, float tread, float rise)
    {
        for (int i = 0; i < steps; i++)
        {
            Riser(rise).Floor(tread);
        }

        return this;
    }

    /// <summary>Repeats a piece until the line has come far enough, and ends on level ground.</summary>
    /// <param name="end">z in metres.</param>
    /// <param name="piece">Goes on by some way.</param>
    public GroundProfile Until(float end, Action<GroundProfile> piece)
    {
        while (Z < end)
        {
            piece(this);
        }

        return this;
    }

    /// <summary>The ground so far.</summary>
    public MeshGround ToGround() => new(positions.ToArray(), triangles.ToArray());

    private void Surface(Vector3 along)
    {
        int first = positions.Count;
        var corner = new Vector3(-halfWidth, Y, Z);
        var across = new Vector3(2f * halfWidth, 0f, 0f);
        positions.AddRange(new[] { corner, corner + along, corner + along + across, corner + across });
        triangles.AddRange(new[] { first, first + 1, first + 2, first, first + 2, first + 3 });
        Y += along.Y;
        Z += along.Z;
    }
}
