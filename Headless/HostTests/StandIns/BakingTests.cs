namespace FastPoints.HostTests.StandIns;

public sealed class BakingTests
{
    World m_world;
    GameObject m_object;
    Authoring m_authoring;

    [SetUp]
    public void MakeAuthoring()
    {
        m_world = new World("bakes");
        m_object = new GameObject("authoring");
        m_authoring = m_object.AddComponent<Authoring>();
        m_authoring.Used = ScriptableObject.CreateInstance<ScriptableObject>();
    }

    [TearDown]
    public void DestroyAuthoring()
    {
        UnityEngine.Object.DestroyImmediate(m_object);
        m_world.Dispose();
    }

    [Test]
    public void Bake_ObjectReadWithoutADependency_IsRefused() =>
        Assert.That(() => Baking.Bake(new CarelessBaker(), m_authoring, m_world),
            Throws.InvalidOperationException.With.Message.Contains("Used"));

    [Test]
    public void GetLayer_OfAnAuthoring_IsADependency()
    {
        m_object.layer = 4;
        var baker = new LayerBaker();
        Baking.Bake(baker, m_authoring, m_world);
        Assert.That(baker.Layer, Is.EqualTo(4));
        Assert.That(baker.Dependencies, Does.Contain(m_object));
    }

    sealed class LayerBaker : Baker<Authoring>
    {
        public int Layer;

        public override void Bake(Authoring authoring)
        {
            DependsOn(authoring.Used);
            Layer = GetLayer();
        }
    }

    [Test]
    public void Bake_OneComponentTwice_IsRefused() =>
        Assert.That(() => Baking.Bake(new DuplicateBaker(), m_authoring, m_world),
            Throws.InvalidOperationException.With.Message.Contains("duplicate"));

    [Test]
    public void Bake_EntityOfAnother_IsRefused() =>
        Assert.That(() => Baking.Bake(new ForeignEntityBaker(m_world.EntityManager.CreateEntity()), m_authoring, m_world),
            Throws.InvalidOperationException.With.Message.Contains("doesn't belong"));

    sealed class Authoring : MonoBehaviour
    {
        public ScriptableObject Used;
    }

    sealed class CarelessBaker : Baker<Authoring>
    {
        public override void Bake(Authoring authoring) =>
            AddComponent(GetEntity(authoring.Used != null ? TransformUsageFlags.Dynamic : TransformUsageFlags.None),
                new LocalToWorld());
    }

    sealed class DuplicateBaker : Baker<Authoring>
    {
        public override void Bake(Authoring authoring)
        {
            DependsOn(authoring.Used);
            AddComponent(GetEntity(TransformUsageFlags.None), new LocalToWorld());
            AddComponent(GetEntity(TransformUsageFlags.None), new LocalToWorld());
        }
    }

    sealed class ForeignEntityBaker(Entity stranger) : Baker<Authoring>
    {
        readonly Entity m_stranger = stranger;

        public override void Bake(Authoring authoring)
        {
            DependsOn(authoring.Used);
            AddComponent(m_stranger, new LocalToWorld());
        }
    }
}
