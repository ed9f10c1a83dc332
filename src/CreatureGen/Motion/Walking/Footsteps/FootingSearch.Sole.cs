using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <content>What is felt under a sole.</content>
internal sealed partial class FootingSearch
{
    /// <summary>How a sole lies on the ground, seen from the plane through the ball's place. Metres of the model.</summary>
    private struct Sole
    {
        public Sole(Vector3 ahead, Vector3 offset)
        {
            this = default;
            Ahead = ahead;
            Aside = new Vector3(ahead.Z, 0f, -ahead.X);
            this.offset = offset;
        }

        private readonly Vector3 offset;

        /// <summary>Where the toes point, level, unit.</summary>
        public Vector3 Ahead;

        /// <summary>To the side of that.</summary>
        public Vector3 Aside;

        /// <summary>Rise towards the toes.</summary>
        public float Slope;

        /// <summary>Rise to the side.</summary>
        public float Tilt;

        /// <summary>Height above the place.</summary>
        public float Raise;

        /// <summary>How high its heel is above bent ground on which its middle stands.</summary>
        public float UnderHeel;

        /// <summary>Height of the ground under its heel, that part of it which counts.</summary>
        public float Below;

        /// <summary>What is below the ends.</summary>
        public SoleEnd Toes;
        public SoleEnd Heel;

        /// <summary>What is below the middle of long toes.</summary>
        public SoleEnd Middle;

        /// <summary>What is below the place right before the toes.</summary>
        public SoleEnd Before;

        /// <summary>A place of it from the ball's place.</summary>
        /// <param name="along">From its ball towards the toes.</param>
        /// <param name="across">To the side.</param>
        public readonly Vector3 At(float along, float across) => offset + (Ahead * along) + (Aside * across);

        /// <summary>Raises it onto the ground at a place.</summary>
        /// <param name="height">Of the ground above the plane.</param>
        /// <param name="along">Towards the toes.</param>
        /// <param name="across">To the side.</param>
        public void StandOn(float height, float along, float across) => Raise = Math.Max(Raise, Raise - Above(height, along, across));

        /// <summary>How high it is above the ground at a place.</summary>
        /// <inheritdoc cref="StandOn"/>
        public readonly float Above(float height, float along, float across) =>
            Raise + ((along + Vec.Dot(offset, Ahead)) * Slope) + ((across + Vec.Dot(offset, Aside)) * Tilt) - height;
    }

    /// <summary>What is below an end of a sole.</summary>
    private enum SoleEnd
    {
        /// <summary>Ground that goes on.</summary>
        Stands,

        /// <summary>Nothing, or ground below an edge.</summary>
        Hangs,

        /// <summary>Ground above a wall, in which it would be.</summary>
        Wall,
    }
}
