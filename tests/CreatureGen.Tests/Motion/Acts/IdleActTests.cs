using System.Collections.Generic;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Motion;
using Xunit;

namespace CreatureGen.Tests.Motion.Acts;

public class IdleActTests
{
    private static readonly MotionProfile dog = new(Walkers.Of(BodyPlan.Digitigrade, 5));

    [Fact]
    public void A_creature_that_stands_about_does_things_by_itself_where_it_is_asked_to_and_the_same_again()
    {
        List<string> acts = Begun(Idling(1f), 240f, default);
        Assert.InRange(acts.Count, 6, 25);
        Assert.InRange(acts.Distinct().Count(), 2, 6);
        Assert.Equal(acts, Begun(Idling(1f), 240f, default));
        Assert.True(Begun(Idling(4f), 240f, default).Count > acts.Count);
    }

    [Fact]
    public void A_creature_does_nothing_by_itself_unless_that_is_set() => Assert.Empty(Begun(Idling(0f), 120f, default));

    [Fact]
    public void A_creature_that_goes_or_is_afraid_does_nothing_by_itself()
    {
        Assert.Empty(Begun(Idling(1f), 90f, new MotionInput(0.8f)));
        CreatureAnimator afraid = Idling(1f);
        afraid.Emotion = new Emotion(1f, -1f, -1f);
        Assert.Empty(Begun(afraid, 90f, default));
    }

    [Fact]
    public void What_a_creature_does_by_itself_gives_way_to_what_it_is_asked()
    {
        CreatureAnimator animator = Idling(4f);
        for (int i = 0; i < 6000 && animator.Act == null; i++)
        {
            animator.Update(1f / 30f, default, FlatGround.Level);
        }

        Assert.NotNull(animator.Act);
        animator.Update(1f / 30f, new MotionInput(1f), FlatGround.Level);
        Assert.Null(animator.Act);
        animator.Perform("Sleep");
        Walkers.Run(animator, 60f, 30f, default, FlatGround.Level);
        Assert.Equal("Sleep", animator.Act?.Name);
    }

    [Fact]
    public void What_a_creature_does_by_itself_allocates_nothing()
    {
        CreatureAnimator animator = Idling(4f);
        Walkers.Run(animator, 60f, 30f, default, FlatGround.Level);

        Assert.Equal(0, MovingPose.Allocated(() => Walkers.Run(animator, 60f, 30f, default, FlatGround.Level), 1));
    }

    private static CreatureAnimator Idling(float often)
    {
        var animator = new CreatureAnimator(dog);
        MotionSettings settings = animator.Settings;
        settings.IdleActs = often;
        animator.Settings = settings;
        return animator;
    }

    private static List<string> Begun(CreatureAnimator animator, float seconds, MotionInput input)
    {
        var acts = new List<string>();
        for (int i = 0; i < seconds * 30f; i++)
        {
            animator.Update(1f / 30f, input, FlatGround.Level);
            foreach (ActEvent item in animator.ActEvents)
            {
                if (item.Mark == ActMark.Begin)
                {
                    acts.Add(item.Act.Name);
                }
            }
        }

        return acts;
    }
}
