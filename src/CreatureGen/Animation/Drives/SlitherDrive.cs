using System;
using System.Numerics;
using CreatureGen.Animation.Grounds;
using CreatureGen.Animation.Strokes.Slithering;
using CreatureGen.Maths;
using CreatureGen.Rigging;
using RootPlace = CreatureGen.Animation.RootMotion.RootPlace;

namespace CreatureGen.Animation.Drives;

/// <summary>Drives a crawler without legs. Its ground is below it along −Y.</summary>
internal sealed class SlitherDrive : IBodyMotion
{
    private readonly SlitherProfile profile;
    private readonly SlitherState state;
    private readonly RayedGround rayed = new();

    public SlitherDrive(SlitherProfile profile)
    {
        this.profile = profile;
        state = new SlitherState(profile);
    }

    public float Speed { get; private set; }

    public float Phase => state.CyclePhase;

    // Along its body it goes further than along its way.
    public float Frequency => Math.Max(Speed, 0f) / (profile.Wavelength * (float)Math.Max(SlitherProfile.Progress(profile.Alpha), 0.1));

    public RootPlace Drive(RootPlace place, float dt, in MotionInput input, LocomotionSettings settings, IGround ground, in Pose local)
    {
        float scale = place.Scale;
        Vector3 ahead = Rotation.Rotate(place.Rotation, Vector3.UnitZ);
        float yaw = (float)PortableMath.Atan2(ahead.X, ahead.Z);
        rayed.Set(ground, scale, place.Position.Y);
        Speed = input.Speed / scale;
        var asked = new SlitherInput(SlitherMode.Undulating, Speed, input.TurnRate, place.Position / scale, yaw);
        Strokes.Slithering.RootPlace root = SlitherMotion.Update(profile, asked, rayed, state, dt, local);
        return new RootPlace(root.Position * scale, AxisTurn.Yaw(root.Yaw), scale);
    }

    public void Follow(in RootPlace place, float dt, in RootPlace goal, LocomotionSettings settings, IGround ground, in Pose local) =>
        Drive(goal, dt, RootStep.Asked(place, dt, goal, MotionMedium.Ground), settings, ground, local);

    public void Stand(in RootPlace place, LocomotionSettings settings, IGround ground, in Pose local)
    {
        state.Reset();
        Drive(place, 0f, default, settings, ground, local);
    }

    public void Rebase(Vector3 offset)
    {
        // The track goes along when the root is found elsewhere.
    }

    /// <summary>Ground by rays, in metres of the model.</summary>
    private sealed class RayedGround : ISlitherGround
    {
        private IGround ground = FlatGround.Level;
        private float scale = 1f;
        private float height;

        public void Set(IGround under, float size, float level)
        {
            ground = under;
            scale = size;
            height = level;
        }

        public float Sample(float x, float z, out Vector3 normal)
        {
            float reach = 2f * scale;
            if (ground.Cast(new Vector3(x * scale, height + reach, z * scale), -Vector3.UnitY, 3f * reach, out GroundHit hit))
            {
                normal = hit.Normal;
                return hit.Point.Y / scale;
            }

            normal = Vector3.UnitY;
            return height / scale;
        }
    }
}
