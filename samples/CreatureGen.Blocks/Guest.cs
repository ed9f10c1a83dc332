using System;
using System.Numerics;
using CreatureGen.Motion;
using CreatureGen.Preview.Pictures;
using CreatureGen.Rigging;

namespace CreatureGen.Blocks;

/// <summary>A person with the joints' names of another program does what grown creatures do, without a clip: it stands, walks, runs, is struck down and gets up. At rest its arms are spread.</summary>
internal static class Guest
{
    /// <summary>Six moments.</summary>
    public static Picture Strip()
    {
        Skeleton person = Walker.Rig();
        var body = new RiggedBody(person);
        var animator = new CreatureAnimator(new MotionProfile(body.Subject));
        IGround ground = new FlatGround(Vector3.Zero, Vector3.UnitY);
        var figure = new BoneStrip(-70, 8, new Vector3(-0.4f, 0f, -0.8f), new Vector3(0.4f, 1.8f, 0.9f), 0.055f);
        Pose local = BoneStrip.Room(person), model = BoneStrip.Room(person);
        int[] shown = [2, 75, 96, 190, 330, 388];
        for (int i = 0; i <= shown[^1]; i++)
        {
            if (i == 240)
            {
                animator.GoLimp();
            }
            else if (i == 340)
            {
                animator.GetUp();
            }

            animator.Update(1f / 60f, new MotionInput(i < 3 || i > 200 ? 0f : i < 110 ? 1.4f : 3.4f), ground);
            body.FillPose(animator.ModelPose, local, model);
            if (Array.IndexOf(shown, i) is >= 0 and int frame)
            {
                figure.Draw(frame, figure.Bones(person, Array.ConvertAll(model.Positions.ToArray(), p => p - new Vector3(0f, body.Ground, 0f))));
            }
        }

        return figure.Picture;
    }
}
