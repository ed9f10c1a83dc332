using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Metrics.Courses;

/// <summary>The inside of a pipe along the X axis, with the origin at its bottom: floor, wall and ceiling in one, and up is towards its axis.</summary>
internal sealed class PipeSurface : CourseSurface
{
    private readonly Pipe pipe;

    /// <summary>Lays a pipe.</summary>
    /// <param name="radius">Metres.</param>
    public PipeSurface(float radius)
        : this(new Pipe(radius))
    {
    }

    private PipeSurface(Pipe pipe)
        : base(pipe) => this.pipe = pipe;

    /// <summary>Metres.</summary>
    public float Radius => pipe.Radius;

    public override bool IsLevel => false;

    public override Vector3 UpAt(Vector3 place) => pipe.UpAt(place);

    public override Vector3? Below(Vector3 place) => new Vector3(place.X, Radius, 0f) - (UpAt(place) * Radius);

    private sealed class Pipe : IGround
    {
        public Pipe(float radius) => Radius = radius;

        public float Radius { get; }

        public Vector3 UpAt(Vector3 place) => Vec.Normalize(new Vector3(0f, Radius - place.Y, -place.Z), Vector3.UnitY);

        public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit)
        {
            // |o + t d|² = r² across the pipe, from within; what begins outside has hit where it is.
            double y = (double)origin.Y - Radius, z = origin.Z;
            double a = ((double)direction.Y * direction.Y) + ((double)direction.Z * direction.Z);
            double b = (y * direction.Y) + (z * direction.Z);
            double c = (y * y) + (z * z) - ((double)Radius * Radius);
            double t = c >= 0 || a < 1e-12 ? 0 : (-b + Math.Sqrt((b * b) - (a * c))) / a;
            Vector3 point = origin + (direction * (float)t);
            hit = new GroundHit(point, UpAt(point));
            return t <= distance && (c >= 0 || a >= 1e-12);
        }
    }
}
