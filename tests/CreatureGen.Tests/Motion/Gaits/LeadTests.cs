using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Motion;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Motion.Gaits;

public sealed class LeadTests
{
    /// <summary>Of the fore feet of a galloping creature the leading one comes down soon after the other, and the other long after it.</summary>
    [Theory]
    [InlineData(0.8f, Side.Left)]
    [InlineData(-0.8f, Side.Right)]
    public void A_gallop_leads_with_the_foot_inside_the_turn(float yawRate, Side side)
    {
        var profile = new MotionProfile(CreatureGenerator.Generate(42, CreatureOptions.Default with { Kind = RequestedKind.Walking, BodyPlans = BodyPlanWeight.Only(BodyPlan.Unguligrade) }));
        var animator = new CreatureAnimator(profile) { Settings = MotionSettings.Default with { Walking = WalkingSettings.Default with { Gait = GaitLibrary.TransverseGallop } } };
        float speed = 2.2f * System.MathF.Sqrt(9.81f * profile.Subject.StandingHeight);
        var downs = new List<(double Time, Side Side)>();
        const float Frame = 1f / 240f;
        for (int i = 0; i < 2400; i++)
        {
            animator.Update(Frame, new MotionInput(speed, yawRate), FlatGround.Level);
            foreach (MotionEvent happened in animator.Events)
            {
                CreatureGen.Rigging.Joint ball = profile.Subject.Skeleton.Joints[happened.Joint];
                if (i > 1200 && happened.Kind == MotionEventKind.FootDown && ball.Name.Contains("1_", System.StringComparison.Ordinal))
                {
                    downs.Add(((i * Frame) - happened.SecondsAgo, ball.Side));
                }
            }
        }

        Assert.True(downs.Count > 10);
        double toLeading = 0;
        double toTrailing = 0;
        for (int i = 1; i < downs.Count; i++)
        {
            double gap = downs[i].Time - downs[i - 1].Time;
            toLeading += downs[i].Side == side ? gap : 0;
            toTrailing += downs[i].Side == side ? 0 : gap;
        }

        Assert.True(toLeading < 0.7 * toTrailing, $"{toLeading:0.00} s before leading feet, {toTrailing:0.00} s before the others");
    }
}
