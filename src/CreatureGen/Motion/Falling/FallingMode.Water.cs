using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Floating;
using CreatureGen.Motion.Modes;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <content>What deep water does.</content>
internal sealed partial class FallingMode
{
    private readonly FloatProfile? floats;
    private Buoyancy? water;

    private Buoyancy Water => water ??= new Buoyancy(floats!, inner, legs!);

    /// <summary>Whether it goes, stands or falls as those do whom water carries that is deep enough.</summary>
    private bool MayFloat => State is BodyState.Falling or BodyState.Landed or BodyState.Leaping || (State == BodyState.Supported && inner.StandsOnFeet);

    /// <summary>Has it swim where it would be under water, and walk where it has ground under its feet; fliers leave water as they are asked into the air.</summary>
    private void Float(in RootPlace place, in WaterReading water, in MotionInput input, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose shown)
    {
        bool flies = inner != legs && input.Medium == MotionMedium.Air;
        bool swims = State == BodyState.Afloat;
        if (swims ? flies || Water.IsAground(water, place, settings) : !flies && MayFloat && Water.IsDeep(water, place, settings))
        {
            Change(!swims, place, settings, ground, layer, shown);
        }
    }

    /// <summary>Begins to swim, or to walk.</summary>
    private void Change(bool swims, in RootPlace place, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose shown)
    {
        if (swims)
        {
            bool falls = State == BodyState.Falling;
            Vector3 velocity = falls ? Fall.Velocity : Rotation.Rotate(place.Rotation, legs!.Velocity.Linear) * place.Scale;
            Water.Begin(place, velocity, legs!.Velocity.YawRate, shown);
            State = BodyState.Afloat;
            Tell(MotionEventKind.EnteredWater, place, settings.Up, falls ? -Vec.Dot(velocity, settings.Up) : Vec.Length(velocity), 0f);
        }
        else
        {
            Tell(MotionEventKind.LeftWater, place, settings.Up, Math.Abs(Water.Speed) * place.Scale, 0f);
            Water.Leave(place, settings, ground, layer, shown);
            State = BodyState.Supported;
        }
    }
}
