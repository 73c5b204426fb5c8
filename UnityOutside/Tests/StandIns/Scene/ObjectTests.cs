namespace UnityOutside.Tests.StandIns;

public sealed class ObjectTests
{
    static readonly List<string> s_told = new List<string>();

    readonly List<string> m_logged = new List<string>();
    GameObject m_object;

    [SetUp]
    public void MakeObject()
    {
        s_told.Clear();
        m_logged.Clear();
        Debug.s_sink = (type, text) => m_logged.Add(type + ": " + text);
        m_object = new GameObject("object");
    }

    [TearDown]
    public void DestroyObject()
    {
        Object.DestroyImmediate(m_object);
        SceneLoop.IsPlaying = false;
        Debug.s_sink = null;
    }

    [Test]
    public void Layer_OutOfRange_IsLoggedAndUnchanged()
    {
        m_object.layer = 31;
        m_object.layer = 32;
        Assert.That(m_object.layer, Is.EqualTo(31));
        Assert.That(m_logged, Has.Count.EqualTo(1).And.All.Contains("[0...31]"));
    }

    [Test]
    public void Destroyed_Object_EqualsNullAndThrows()
    {
        var reported = m_object.AddComponent<AlwaysTold>();
        reported.Kept = 3;
        Object.DestroyImmediate(m_object);
        Assert.That(m_object == null && reported == null && !reported, Is.True);
        Assert.That(ReferenceEquals(reported, null), Is.False);
        Assert.That(reported.Kept, Is.EqualTo(3), "its own");
        Assert.That(() => m_object.name, Throws.TypeOf<MissingReferenceException>());
        Assert.That(() => reported.gameObject, Throws.TypeOf<MissingReferenceException>());
        Assert.That(() => reported.enabled, Throws.TypeOf<MissingReferenceException>());
        Assert.That(() => reported.transform, Throws.TypeOf<MissingReferenceException>());
    }

    [Test]
    public void Destroy_InEditMode_IsRefused()
    {
        Object.Destroy(m_object);
        SceneLoop.Update();
        Assert.That(m_object != null, Is.True);
        Assert.That(m_logged, Has.Count.EqualTo(1).And.Some.Contains("edit mode"));
    }

    [Test]
    public void Destroy_InPlayMode_IsAtTheFramesEnd()
    {
        SceneLoop.IsPlaying = true;
        var child = new GameObject("child");
        child.transform.SetParent(m_object.transform, false);
        Object.Destroy(m_object);
        Assert.That(m_object != null, Is.True);
        SceneLoop.Update();
        Assert.That(m_object == null && child == null, Is.True, "children go with it");
    }

    [Test]
    public void Messages_InEditMode_ReachExecuteAlwaysOnly()
    {
        m_object.AddComponent<Told>();
        Assert.That(s_told, Is.EqualTo(new[] { "Reset" }));
        s_told.Clear();
        var always = m_object.AddComponent<AlwaysTold>();
        SceneLoop.Update();
        always.enabled = false;
        always.enabled = true;
        Object.DestroyImmediate(m_object);
        Assert.That(s_told, Is.EqualTo(new[]
        {
            "Awake", "OnEnable", "Reset", "Start", "Update", "OnDisable", "OnEnable", "OnDisable", "OnDestroy",
        }));
    }

    [Test]
    public void Messages_InPlayMode_WaitUntilTheObjectIsActive()
    {
        SceneLoop.IsPlaying = true;
        var parent = new GameObject("parent");
        parent.SetActive(false);
        m_object.transform.SetParent(parent.transform, false);
        var reported = m_object.AddComponent<Told>();
        SceneLoop.Update();
        Assert.That(s_told, Is.Empty);
        Assert.That((reported.enabled, reported.isActiveAndEnabled), Is.EqualTo((true, false)));
        parent.SetActive(true);
        Assert.That(s_told, Is.EqualTo(new[] { "Awake", "OnEnable" }));
        parent.SetActive(false);
        Object.DestroyImmediate(parent);
        Assert.That(s_told, Is.EqualTo(new[] { "Awake", "OnEnable", "OnDisable", "OnDestroy" }));
    }

    [Test]
    public void Destroyed_BehaviourThatNeverWoke_GetsNoCallback()
    {
        SceneLoop.IsPlaying = true;
        m_object.SetActive(false);
        m_object.AddComponent<Told>();
        Object.DestroyImmediate(m_object);
        Assert.That(s_told, Is.Empty);
    }

    [Test]
    public void AddComponent_DisallowedDuplicate_ReturnsNull()
    {
        m_object.AddComponent<Single>();
        Assert.That(m_object.AddComponent<Single>(), Is.Null);
        Assert.That(m_logged, Has.Count.EqualTo(1));
    }

    [Test]
    public void FindObjectsOfTypeAll_Components_IncludesDisabledOnes()
    {
        m_object.SetActive(false);
        var off = m_object.AddComponent<Told>();
        Assert.That(Resources.FindObjectsOfTypeAll<Told>(), Is.EqualTo(new[] { off }));
        Object.DestroyImmediate(off);
        Assert.That(Resources.FindObjectsOfTypeAll<Told>(), Is.Empty);
    }

    [ExecuteAlways]
    sealed class AlwaysTold : MonoBehaviour
    {
        public int Kept;

        void Awake() => s_told.Add("Awake");
        void OnEnable() => s_told.Add("OnEnable");
        void Reset() => s_told.Add("Reset");
        void Start() => s_told.Add("Start");
        void Update() => s_told.Add("Update");
        void OnDisable() => s_told.Add("OnDisable");
        void OnDestroy() => s_told.Add("OnDestroy");
    }

    sealed class Told : MonoBehaviour
    {
        void Awake() => s_told.Add("Awake");
        void OnEnable() => s_told.Add("OnEnable");
        void Reset() => s_told.Add("Reset");
        void OnDisable() => s_told.Add("OnDisable");
        void OnDestroy() => s_told.Add("OnDestroy");
    }

    [DisallowMultipleComponent]
    sealed class Single : MonoBehaviour { }
}
