using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Seeding;

namespace CreatureGen.Lab.Runtime;

/// <summary>What a creature wants: to stay, to stroll about its home, or to come where it is called.</summary>
internal sealed class Mind
{
    /// <summary>How near to its food it tries to eat, parts of its length, from far to near.</summary>
    private static readonly float[] tables = [0.66f, 0.58f, 0.5f, 0.42f, 0.34f];

    /// <summary>How far a swimmer's lowest point is below the surface of a lake at least, parts of its height: its back shows.</summary>
    private const float SwimmingDepth = 0.8f;

    /// <summary>What it passes its time with, and what it does if it cannot do that.</summary>
    private static readonly string[] pastimes = ["Sniff", "Shake", "Scratch", "Groom", "Call"];
    private const string Substitute = "Sniff";

    /// <summary>Milliseconds of a move in which it tries what it is about to do.</summary>
    private const double Trial = 3.0;

    private readonly RandomStream chance;
    private SeekState seek;
    private Habit habit = Habit.Stay;
    private Vector2 home;
    private Vector2 goal;
    private float radius = 6f;
    private float timer;
    private bool travels;
    private bool called;
    private bool airborne;
    private Vector3? food;
    private int table;
    private bool eats;
    private float feels;
    private float bored = 5f;
    private string? pastime;

    public Mind(int slot) => chance = new Seed(0x6c6162).Child("mind").Child(slot).Stream();

    private enum Habit
    {
        Stay,
        Wander,
        March,
    }

    public void Take(string name, float x, float z, float homeRadius)
    {
        habit = name switch { "wander" => Habit.Wander, "march" => Habit.March, _ => Habit.Stay };
        home = new Vector2(x, z);
        radius = homeRadius;
        travels = false;
        airborne = false;
        timer = (float)chance.Uniform(0.3, 4.0);
    }

    /// <summary>Calls it to a place.</summary>
    public void GoTo(float x, float z)
    {
        goal = new Vector2(x, z);
        home = goal;
        travels = true;
        called = true;
        timer = 60f;
    }

    /// <summary>Calls it towards a place, no farther from its home than it strays.</summary>
    public void ComeNear(float x, float z)
    {
        Vector2 way = new Vector2(x, z) - home;
        Vector2 from = home;
        Vector2 near = home + (way * Math.Min(1f, radius / Math.Max(way.Length(), 1e-3f)));
        GoTo(near.X, near.Y);
        home = from;
    }

    /// <summary>Offers it food: it comes and eats.</summary>
    public void Feed(float x, float y, float z)
    {
        GoTo(x, z);
        food = new Vector3(x, y, z);
        table = 0;
        eats = false;
    }

    /// <summary>What it feels for a while.</summary>
    public void Feel(Actor self, Emotion emotion, float seconds)
    {
        self.Animator.Emotion = emotion;
        feels = seconds;
    }

    /// <summary>What it does now.</summary>
    public MotionInput Decide(Actor self, float seconds, Stage stage)
    {
        Abilities can = self.Abilities;
        RootPlace place = self.Animator.Root;
        timer -= seconds;
        feels -= seconds;
        if (feels < 0f && feels + seconds >= 0f)
        {
            self.Animator.Emotion = default;
        }

        bool inAir = can.CanFly && (airborne || can.Medium == Medium.Air);
        MotionMedium medium = inAir ? MotionMedium.Air : MotionMedium.Ground;
        if (self.Animator.State is not BodyState.Supported)
        {
            return default;
        }

        if (habit == Habit.March)
        {
            return new MotionInput(inAir ? can.FlightSpeed : can.Pace, Medium: medium);
        }

        if (self.Animator.Act != null && (eats || !travels))
        {
            bored = (float)chance.Uniform(6.0, 16.0);
            return new MotionInput(0f, Medium: medium);
        }

        if (eats)
        {
            eats = false;
            food = null;
            travels = false;
            Feel(self, new Emotion(0.3f, 0.9f, 0f), 4f);
        }

        if (food is { } meal && self.Deeds.Try("Eat", Trial) && self.Deeds.Try(Substitute, Trial) && Eats(self, meal))
        {
            return new MotionInput(0f, Medium: medium);
        }

        Idle(self, seconds, can);
        if (timer <= 0f && habit == Habit.Wander)
        {
            Choose(can, stage.Land);
        }

        inAir = can.CanFly && (airborne || can.Medium == Medium.Air);
        medium = inAir ? MotionMedium.Air : MotionMedium.Ground;
        if (!travels && !inAir && can.Medium != Medium.Water)
        {
            return default;
        }

        Vector2 here = new(place.Position.X, place.Position.Z);
        Vector2 target = travels ? goal : habit == Habit.Wander ? home + (radius * Circle(self)) : home;
        if (travels && food == null && Vector2.Distance(here, goal) < 0.8f * can.Length)
        {
            travels = false;
            called = false;
            timer = (float)chance.Uniform(2.5, 7.0);
        }

        bool hovers = !travels && habit == Habit.Stay;
        Vector2 bent = target + Avoid(self, here, stage);
        Vector3 local = place.ToModel(new Vector3(bent.X, place.Position.Y, bent.Y));
        bool far = Vector2.Distance(here, target) > 5f * can.Length;
        float speed = inAir ? can.FlightSpeed : called && far ? can.Run : can.Pace;
        var settings = new SeekSettings(speed, inAir || can.Medium == Medium.Water ? 1.2f : 1.5f, 0f, (food == null ? 0.6f : 0.2f) * can.Length, 0.12f, 0.04f, 1.9f);
        BodyVelocity wish = Seek.Decide(ref seek, settings, local);
        float climb = inAir || can.Medium == Medium.Water ? Climb(self, place, stage.Land, inAir) : 0f;
        return hovers && Vector2.Distance(here, home) < can.Length
            ? new MotionInput(0f, 0f, ClimbRate: climb, Medium: medium)
            : new MotionInput(wish.Linear.Z, wish.YawRate, ClimbRate: climb, Medium: medium);
    }

    private static float Climb(Actor self, RootPlace place, Land land, bool inAir)
    {
        Abilities can = self.Abilities;
        float ground = land.HeightAt(place.Position.X, place.Position.Z);
        float level = inAir ? ground + Math.Max(1.6f * can.Length, can.Rise) : Math.Min(ground + (can.Rise * (1.2f + (0.5f * (self.Slot % 4)))), land.Surface - (SwimmingDepth * can.Height));
        float most = 0.35f * Math.Max(can.Pace, can.FlightSpeed);
        return Math.Clamp(0.8f * (level - place.Position.Y), -most, most);
    }

    /// <summary>A round about its home, for those that cannot stand still.</summary>
    private static Vector2 Circle(Actor self)
    {
        double angle = Math.Atan2(self.Position.X, self.Position.Z) + 0.7;
        return new Vector2((float)Math.Sin(angle), (float)Math.Cos(angle));
    }

    /// <summary>Whether it begins to eat: as soon as its mouth reaches the food, or, very near, as if it did.</summary>
    private bool Eats(Actor self, Vector3 meal)
    {
        float apart = Vector2.Distance(new Vector2(self.Position.X, self.Position.Z), new Vector2(meal.X, meal.Z)) / self.Abilities.Length;
        Vector3 local = self.Animator.Root.ToModel(meal);
        if (table >= tables.Length || apart > tables[table] || local.Z <= 0f)
        {
            return false;
        }

        table++;
        eats = self.Deeds.Perform("Eat", ActTarget.At(meal)).Length == 0 || (table == tables.Length && self.Deeds.PerformAny(["Eat", Substitute]));
        if (table == tables.Length && !eats)
        {
            food = null;
            travels = false;
        }

        return eats;
    }

    /// <summary>What it does to pass the time.</summary>
    private void Idle(Actor self, float seconds, Abilities can)
    {
        bored -= seconds;
        if (bored <= 0f && !travels && can.Medium == Medium.Ground && !airborne)
        {
            bored = (float)chance.Uniform(7.0, 18.0);
            pastime = pastimes[(int)(chance.Uniform() * pastimes.Length)];
        }

        if (pastime is { } wanted && !travels && self.Deeds.Try(wanted, Trial) && self.Deeds.Try(Substitute, Trial))
        {
            pastime = null;
            self.Deeds.PerformAny([wanted, Substitute]);
        }
    }

    private void Choose(Abilities can, Land land)
    {
        if (can.CanFly && can.Medium == Medium.Ground)
        {
            airborne = chance.Chance(0.65);
        }

        travels = chance.Chance(0.75) || airborne;
        double angle = chance.Uniform(0.0, 2.0 * Math.PI);
        double away = radius * Math.Sqrt(chance.Uniform());
        float edge = 0.85f * land.HalfWidth;
        goal = new Vector2(Math.Clamp(home.X + (float)(away * Math.Sin(angle)), -edge, edge), Math.Clamp(home.Y + (float)(away * Math.Cos(angle)), -edge, edge));
        timer = travels ? (float)chance.Uniform(8.0, 16.0) : (float)chance.Uniform(2.0, 6.0);
    }

    /// <summary>How far the way bends round others that are near.</summary>
    private static Vector2 Avoid(Actor self, Vector2 here, Stage stage)
    {
        Vector2 bend = Vector2.Zero;
        foreach (Actor other in stage.Living)
        {
            // Written out: most are far, and all ask about all.
            Vector3 there = other.Position;
            float x = here.X - there.X;
            float z = here.Y - there.Z;
            float room = 0.75f * (self.Abilities.Length + other.Abilities.Length);
            float apart = (x * x) + (z * z);
            if (apart < room * room && other != self)
            {
                apart = Math.Max((float)Math.Sqrt(apart), 1e-4f);
                bend += new Vector2(x, z) * (3f * (room - apart) / apart);
            }
        }

        return bend;
    }
}
