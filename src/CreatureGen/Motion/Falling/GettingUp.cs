using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Motion.Toolkit.Ik;
using CreatureGen.Motion.Walking;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <summary>
/// Gets up by phases: the head rises first, legs are gathered, those out to the side over the ground, those under the body drawn in along it, the body rolls onto its belly by the shorter side, its trunk on the ground but for what its legs heave it up; then it rises onto its feet.
/// What has no legs rights itself only.
/// </summary>
internal sealed class GettingUp
{
    /// <summary>Time of the gathering, τ = √(ℓ/g), of a body that lies on its belly, and of one that has to roll over by so many radians or more.</summary>
    private const float GatherTime = 3.4f;
    private const float RollTime = 5.4f;
    private const float Rolled = 1.6f;

    /// <summary>What of its skin is in the ground is out of it after this time, and its trunk has come down onto the ground after that, τ.</summary>
    private const float ClearTime = 0.6f;
    private const float SettleTime = 1.25f;

    /// <summary>Part of the gathering in which legs under the body are drawn in: most of it while the body is still on its side. Feet that are not there before it rolls over onto them have to pass below it, and lift it off the ground.</summary>
    private const float DrawnIn = 0.68f;

    /// <summary>Part of the gathering at which its trunk begins to be as high as it will stand.</summary>
    private const float Raised = 0.5f;

    /// <summary>Part of the rise in which a body comes down again that head, tail or wings keep off the ground once it has gathered itself.</summary>
    private const float Lowered = 0.4f;

    /// <summary>How much higher than where it rises from it may heave itself, leg lengths: from higher it rises at once.</summary>
    private const float MaxHeave = 0.08f;

    /// <summary>How much more it may heave itself for that, leg lengths.</summary>
    private const float MoreHeave = 0.03f;

    /// <summary>How quickly it comes down where it would hang in the air as it rises, 1/τ.</summary>
    private const float LowerRate = 6f;

    /// <summary>How fast the joints of legs turn towards where they belong at most, radians per τ.</summary>
    private const float FastestLimb = 4f;

    /// <summary>How far below where it stands its trunk is, and how far from their places its feet are, where it counts as standing; leg lengths.</summary>
    private const float HardlyLow = 0.05f;
    private const float HardlyAstray = 0.03f;

    /// <summary>What is left of the rise dies away on the walk in this time, τ.</summary>
    private const float FadeTime = 1.2f;

    private readonly FallProfile profile;
    private readonly ILocomotionMode inner;
    private readonly IRise? rising;
    private readonly bool draws;
    private readonly Vector3[] ankles;
    private readonly Vector3[] standing;
    private readonly LocalPose last;
    private readonly PoseFade fade;
    private readonly PoseBuffer from;
    private readonly LocalPose to;
    private readonly PoseBuffer shown;
    private readonly LocalPose folded;
    private readonly TrunkHeave heave;

    // Wings whose shortest way leads out of their limits.
    private readonly bool[] goesAround;
    private BodyTurn fromTurn;
    private BodyTurn toTurn;
    private float unit;
    private float gather;
    private float rise;
    private float elapsed;
    private float gap;
    private float height;
    private float lowered;
    private Clearing over;

    public GettingUp(FallProfile profile, ILocomotionMode inner, WalkingMode? legs)
    {
        this.profile = profile;
        this.inner = inner;
        rising = legs == null ? null : profile.Lying is LyingManner lying ? new BellyRise(profile, lying, legs) : new CrouchRise(profile, legs);
        draws = !profile.Swims && Array.Exists(profile.Legs, leg => !leg.Lateral);
        heave = new TrunkHeave(profile);
        from = new PoseBuffer(profile.Skeleton);
        to = new LocalPose(profile.Skeleton);
        shown = new PoseBuffer(profile.Skeleton);
        ankles = new Vector3[profile.Skeleton.Count];
        standing = new Vector3[profile.Skeleton.Count];
        last = new LocalPose(profile.Skeleton);
        fade = new PoseFade(profile.Skeleton);
        goesAround = new bool[profile.Skeleton.Count];
        folded = new LocalPose(profile.Skeleton);
    }

    /// <summary>Begins.</summary>
    /// <param name="limp">How it lies.</param>
    /// <param name="place">Where it will stand.</param>
    /// <param name="settings">Up and gravity.</param>
    /// <param name="ground">What it lies on.</param>
    /// <param name="layer">What an act asks of trunk and feet.</param>
    public void Begin(LimpBody limp, in RootPlace place, in MotionSettings settings, IGround ground, BodyLayer? layer)
    {
        limp.Show(place, 0f, settings, ground, from.Local);
        from.Finish();
        Prepare(float.MinValue, place, settings, ground, layer);
        if (!draws)
        {
            return;
        }

        float height = Foresee(place, settings, ground);
        if (rise > 0f && height - Lies() > MaxHeave * profile.Height)
        {
            Prepare(height, place, settings, ground, layer);
            if (Foresee(place, settings, ground) > Math.Max(height, Lies()) + (MoreHeave * profile.Height))
            {
                // Its legs come to there by a way that is higher yet.
                Prepare(float.MinValue, place, settings, ground, layer);
                Foresee(place, settings, ground);
            }
        }
    }

    /// <summary>How high the middle of its trunk is where it rises from, metres of the model.</summary>
    private float Lies()
    {
        shown.Take(to.Pose);
        shown.Finish();
        return profile.TrunkHeight(shown.Model);
    }

    /// <summary>Finds where it rises from, and how long it takes.</summary>
    /// <param name="height">How high its trunk is to be there, metres of the model.</param>
    /// <param name="place">Where it will stand.</param>
    /// <param name="settings">Up and gravity.</param>
    /// <param name="ground">What it lies on.</param>
    /// <param name="layer">What an act asks of trunk and feet.</param>
    private void Prepare(float height, in RootPlace place, in MotionSettings settings, IGround ground, BodyLayer? layer)
    {
        folded.Take(from.Local);
        to.SetToRest();
        inner.Stand(place, settings, ground, layer, to.Pose);
        shown.Take(to.Pose);
        shown.Finish();
        shown.Model.Positions.CopyTo(standing);
        this.height = profile.TrunkHeight(shown.Model);
        bool rises = rising != null && inner.IsOnFeet;
        if (rises)
        {
            rising!.Begin(place, settings, ground, layer, height, to.Pose);
        }

        for (int j = 0; j < goesAround.Length; j++)
        {
            Joint joint = profile.Skeleton.Joints[j];
            goesAround[j] = joint.Role == JointRole.Wing && SwingTwistBlend.IsNeeded(from.Local.Rotations[j], to.Pose.Rotations[j], joint);
        }

        shown.Take(to.Pose);
        shown.Finish();
        shown.Model.Positions.CopyTo(ankles);
        fromTurn = BodyTurn.Of(profile, from.Local);
        toTurn = BodyTurn.Of(profile, to.Pose);
        gap = profile.Support.Lowest(place, from.Model, settings.Up, ground);
        float tau = (float)Math.Sqrt(profile.Height * place.Scale / settings.Gravity);
        unit = tau * profile.Manner.Tempo;
        gather = Scalar.Lerp(GatherTime, RollTime, Scalar.Smooth(Math.Max(Math.Abs(fromTurn.Pitch - toTurn.Pitch), Math.Abs(fromTurn.Roll - toTurn.Roll)) / Rolled)) * unit;
        rise = rises ? rising!.Seconds(tau) : 0f;
        (elapsed, lowered) = (0f, 0f);
        over = profile.Swims ? default : GroundClearance.Clear(profile, shown, place, 0f, settings.Up, ground);
    }

    /// <summary>Goes on.</summary>
    /// <param name="place">Where it will stand.</param>
    /// <param name="dt">Seconds.</param>
    /// <param name="settings">Up and gravity.</param>
    /// <param name="ground">What it lies on.</param>
    /// <param name="layer">What an act asks of trunk and feet.</param>
    /// <param name="local">Receives the pose.</param>
    /// <returns>Whether it is over.</returns>
    public bool Advance(in RootPlace place, float dt, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local)
    {
        elapsed += dt;
        Stands = false;
        if (elapsed < gather)
        {
            float part = elapsed / gather;
            Gather(part, dt, draws ? heave.At(part) : default, place, settings, ground);
            if (!profile.Swims)
            {
                GroundClearance.Clear(profile, shown, place, DepthAt(part), settings.Up, ground);
            }

            shown.Local.Rotations.CopyTo(local.Rotations);
            shown.Local.Positions.CopyTo(local.Positions);
            return false;
        }

        float u = rise > 0f ? (elapsed - gather) / rise : 1f;
        to.Pose.Rotations.CopyTo(local.Rotations);
        to.Pose.Positions.CopyTo(local.Positions);
        if (rise > 0f)
        {
            rising!.Show(Math.Min(u, 1f), place, dt, settings, layer, local);
            float kept = 1f - Scalar.Smooth(u / Lowered);
            profile.Raise(local, over.OfLimbs * kept);
            shown.Take(local);
            Lower(place, dt, settings, ground);
            GroundClearance.BendUp(profile, shown, place, settings.Up, ground);
            shown.Local.Rotations.CopyTo(local.Rotations);
            shown.Local.Positions.CopyTo(local.Positions);
            profile.Raise(local, over.OfEnds * kept);
            Stands = kept == 0f && IsUp();
        }

        return u >= 1f;
    }

    /// <summary>Whether it has gathered itself, and rises onto its feet.</summary>
    public bool Rises => elapsed >= gather;

    /// <summary>Whether it stands, but for what little is left of the rise: that can go on as it walks.</summary>
    public bool Stands { get; private set; }

    /// <summary>Takes note of what is shown, before it goes on.</summary>
    public void Keep(in Pose local) => last.Take(local);

    /// <summary>Leaves what is left of the rise to the walk.</summary>
    /// <param name="dt">Seconds since the pose that was kept.</param>
    /// <param name="local">The pose as it is shown.</param>
    public void Leave(float dt, in Pose local) => fade.Keep(local, last.Pose, dt);

    /// <summary>Lays what is left of the rise on the walk.</summary>
    public void Fade(float dt, float tau, in Pose local) => fade.Apply(dt, FadeTime * tau, local);

    /// <summary>Forgets what was left of it.</summary>
    public void Stop() => fade.Stop();

    /// <summary>Goes on from where another is.</summary>
    public void CopyFrom(GettingUp other)
    {
        from.Take(other.from.Local);
        to.Take(other.to.Pose);
        folded.Take(other.folded.Pose);
        (fromTurn, toTurn, unit, gather, rise, elapsed, gap, over) = (other.fromTurn, other.toTurn, other.unit, other.gather, other.rise, other.elapsed, other.gap, other.over);
        rising?.CopyFrom(other.rising!);
        heave.CopyFrom(other.heave);
        other.ankles.CopyTo(ankles, 0);
        other.standing.CopyTo(standing, 0);
        last.Take(other.last.Pose);
        fade.CopyFrom(other.fade);
        (Stands, height, lowered) = (other.Stands, other.height, other.lowered);
        other.goesAround.CopyTo(goesAround, 0);
    }

    /// <summary>Lets a body down that hangs in the air: the ground of the act by which it rises is a plane, and treads of stairs are below that.</summary>
    private void Lower(in RootPlace place, float dt, in MotionSettings settings, IGround ground)
    {
        shown.Finish();
        float hangs = Math.Max(0f, profile.Support.Lowest(BodyPart.Trunk | BodyPart.Limb, place, shown.Model, settings.Up, ground, out _));
        lowered = Math.Min(hangs, Damping.Approach(lowered, hangs, LowerRate / unit, dt));
        profile.Raise(shown.Local, -lowered);
        shown.Finish();
    }

    /// <summary>Whether its trunk is about as high as it stands, and its feet are where they stand.</summary>
    private bool IsUp()
    {
        bool up = profile.TrunkHeight(shown.Model) > height - (HardlyLow * profile.Height);
        foreach (LyingLeg leg in profile.Legs)
        {
            int ankle = leg.Rig.Ankle;
            up &= Vec.Distance(shown.Model.Positions[ankle], standing[ankle]) < HardlyAstray * profile.Height;
        }

        return up;
    }

    /// <summary>Finds how high the body has to heave itself as it draws its legs in, and how high the middle of its trunk comes, metres of the model.</summary>
    private float Foresee(in RootPlace place, in MotionSettings settings, IGround ground)
    {
        float highest = float.MinValue;
        for (int i = 0; i <= Heave.Parts; i++)
        {
            float u = (float)i / Heave.Parts;
            Gather(u, gather / Heave.Parts, default, place, settings, ground);
            highest = Math.Max(highest, heave.Ask(i, (float)PortableMath.Cos(BodyTurn.Between(fromTurn, toTurn, u).Roll), shown, place, DepthAt(u), settings.Up, ground));
        }

        heave.Finish();
        folded.Take(from.Local);
        return highest;
    }

    /// <summary>How far below the ground skin may be: less and less of what was in it, metres of the model, not positive.</summary>
    private float DepthAt(float u) => Math.Min(gap, 0f) * (1f - Scalar.Smooth(u * gather / (ClearTime * unit)));

    /// <summary>Rolls onto the belly and gathers the legs.</summary>
    /// <param name="u">Part of the time, 0..1.</param>
    /// <param name="dt">Seconds since the last.</param>
    /// <param name="heaved">How its trunk is heaved up from how it would lie.</param>
    /// <param name="place">Where it will stand.</param>
    /// <param name="settings">Up and gravity.</param>
    /// <param name="ground">What it lies on.</param>
    private void Gather(float u, float dt, in Heaved heaved, in RootPlace place, in MotionSettings settings, IGround ground)
    {
        for (int j = 0; j < profile.Skeleton.Count; j++)
        {
            float w = profile.Windows[j].At(u);
            shown.Local.Rotations[j] = goesAround[j]
                ? SwingTwistBlend.Between(from.Local.Rotations[j], to.Pose.Rotations[j], w, profile.Skeleton.Joints[j])
                : Rotation.Slerp(from.Local.Rotations[j], to.Pose.Rotations[j], w);
            shown.Local.Positions[j] = Vec.Lerp(from.Local.Positions[j], to.Pose.Positions[j], w);
        }

        SwingTwistLimit.ClampPose(profile.Skeleton, shown.Local);
        int body = profile.Body;
        BodyTurn turn = BodyTurn.Between(fromTurn, toTurn, u);
        (turn with { Pitch = turn.Pitch - heaved.Pitch }).Set(profile, shown.Local);
        shown.Local.Positions[body] = Vec.Lerp(from.Local.Positions[body], to.Pose.Positions[body], Scalar.Smooth(u));
        shown.Finish();
        if (profile.Swims)
        {
            return;
        }

        // Its trunk lies on the ground while its legs are gathered.
        float depth = DepthAt(u);
        float home = Scalar.Smooth((u - Raised) / (1f - Raised));
        GroundClearance.Settle(profile, shown, place, depth, Scalar.Smooth(u * gather / (SettleTime * unit)) * (1f - home), settings.Up, ground);
        profile.Raise(shown.Local, heaved.Raised);
        shown.Finish();

        // Feet come up with a body that heaves itself up over them: stretched after the ground they would lift it higher than it was foreseen.
        for (int i = 0; i < profile.Legs.Length; i++)
        {
            LyingLeg leg = profile.Legs[i];
            if (leg.Lateral)
            {
                continue;
            }

            int ankle = leg.Rig.Ankle;
            var raised = new Vector3(0f, heave.IsFore(i) ? heaved.Fore : heaved.Hind, 0f);
            LimbDraw.Apply(profile.Skeleton, leg, from.Model.Positions[ankle] + raised, ankles[ankle] + raised, Scalar.Smooth(u / DrawnIn), shown);
        }

        LimbFold.Up(profile, profile.Limbs, shown, folded.Pose, FastestLimb * dt / unit, home, place, depth, settings.Up, ground);
    }
}
