using CreatureGen.Motion.Grounds;
using CreatureGen.Rigging;

namespace CreatureGen.Motion;

/// <content>What is seen of it from afar.</content>
public sealed partial class CreatureAnimator
{
    private DistantMotion? distant;

    /// <summary>Whether it only travels, and shows the cycle of its gait: it is to be seen from afar, and does nothing else.</summary>
    private bool OnlyRootMoves(in RootPlace place, IGround ground) => settings.Detail == MotionDetail.Far && distant!.Body != null && Mode!.OnlyWalks(place, settings, ground) && actor?.Performer is not { IsActive: true };

    /// <summary>Moves on as asked, as it is seen from afar.</summary>
    /// <returns>Whether it does; else it moves in full, from where it is.</returns>
    private bool GoesAfar(float dt, in MotionInput input, CheckedGround ground)
    {
        if (distant == null)
        {
            return false;
        }

        distant.Turn(settings.Detail, LocalPose);
        if (OnlyRootMoves(root, ground))
        {
            BeginAfar();
            if (Legs!.AdvanceRoot(root, dt, input, settings, ground, out RootPlace next))
            {
                root = next;
                FinishAfar(dt);
                return true;
            }
        }

        Approach(ground);
        return false;
    }

    /// <summary>The same where the game moves it.</summary>
    private bool FollowsAfar(float dt, in RootPlace placement, CheckedGround ground)
    {
        if (distant == null || Mode == null)
        {
            return false;
        }

        distant.Turn(settings.Detail, LocalPose);
        if (OnlyRootMoves(placement, ground))
        {
            BeginAfar();
            if (Legs!.AdvanceRootAlong(root, dt, placement, settings, ground))
            {
                root = placement;
                FinishAfar(dt);
                return true;
            }
        }

        Approach(ground);
        return false;
    }

    /// <summary>Goes on in full.</summary>
    private void Approach(CheckedGround ground)
    {
        if (distant!.MovesRoot)
        {
            locomotion.Resume(root, settings, ground, LocalPose);
            distant.End(LocalPose);
        }
    }

    /// <summary>Begins to travel if it does not yet: what swings and looks about begins anew when it is seen from near again.</summary>
    private void BeginAfar()
    {
        if (!distant!.MovesRoot)
        {
            distant.Begin(Legs!, LocalPose);
            secondary.Reset();
            headGaze?.Reset();
            secondHead?.Reset();
        }
    }

    private void FinishAfar(float dt)
    {
        distant!.Pose(Legs!, LocalPose);
        distant.Fade(dt, LocalPose);
        ForwardKinematics.LocalToModel(Profile.Subject.Skeleton, LocalPose, ModelPose);
    }
}
