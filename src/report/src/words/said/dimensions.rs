//! What an explanation by the dimensions of a damper says.

use super::Said;

/// In the order of its phrases.
pub const ALL: &[Said] = &[
    // Why a quantity cannot be told.
    [
        "the model has no gas force; a slow test shows it",
        "das Modell hat keine Gaskraft; ein langsamer Versuch zeigt sie",
        "le modèle n’a pas d’effort de gaz ; un essai lent le montre",
        "模型没有气体力；慢速试验可显示它",
    ],
    [
        "the records leave the gas force open; a slow test shows it",
        "die Messungen lassen die Gaskraft offen; ein langsamer Versuch zeigt sie",
        "les mesures laissent l’effort de gaz ouvert ; un essai lent le montre",
        "记录不能确定气体力；慢速试验可显示它",
    ],
    [
        "the gas pushes on the area of the rod",
        "das Gas drückt auf die Fläche der Stange",
        "le gaz pousse sur la section de la tige",
        "气体作用在活塞杆面积上",
    ],
    [
        "the model has no gas spring; slow strokes over the whole travel show it",
        "das Modell hat keine Gasfeder; langsame Hübe über den ganzen Weg zeigen sie",
        "le modèle n’a pas de ressort à gaz ; des courses lentes sur tout le débattement le montrent",
        "模型没有气体弹簧；覆盖全行程的慢速试验可显示它",
    ],
    [
        "the records leave the gas stiffness open; slow strokes over the whole travel show it",
        "die Messungen lassen die Gassteifigkeit offen; langsame Hübe über den ganzen Weg zeigen sie",
        "les mesures laissent la raideur du gaz ouverte ; des courses lentes sur tout le débattement la montrent",
        "记录不能确定气体刚度；覆盖全行程的慢速试验可显示它",
    ],
    [
        "it follows from the pressure and the stiffness of the gas",
        "es folgt aus Druck und Steifigkeit des Gases",
        "il découle de la pression et de la raideur du gaz",
        "由气体的压力和刚度得出",
    ],
    [
        "the stiffness of the column is one of a chamber with area and length",
        "die Steifigkeit der Säule ist die einer Kammer mit Fläche und Länge",
        "la raideur de la colonne est celle d’une chambre de section et de longueur données",
        "油柱刚度取决于腔室的面积和长度",
    ],
    [
        "the model has no oil column and no series spring that the records determine",
        "das Modell hat weder Ölsäule noch Reihenfeder, die die Messungen bestimmen",
        "le modèle n’a ni colonne d’huile ni ressort en série que les mesures déterminent",
        "模型没有由记录确定的油柱或串联弹簧",
    ],
    [
        "the effective modulus is not known",
        "der effektive Modul ist nicht bekannt",
        "le module effectif n’est pas connu",
        "有效模量未知",
    ],
    [
        "the tube expands with the oil",
        "das Rohr dehnt sich mit dem Öl",
        "le tube se dilate avec l’huile",
        "缸筒随油液膨胀",
    ],
    [
        "the stroke that air yields goes with its pressure and the length of the chamber",
        "der Weg, den Luft nachgibt, hängt von ihrem Druck und der Länge der Kammer ab",
        "la course que cède l’air dépend de sa pression et de la longueur de la chambre",
        "空气让出的行程取决于其压力和腔室长度",
    ],
    [
        "it is what the modulus of the oil lacks, or the stroke of the element aeration",
        "es ist das, was dem Modul des Öls fehlt, oder der Weg des Elements aeration",
        "c’est ce qui manque au module de l’huile, ou la course de l’élément aeration",
        "它是油液模量的缺失部分，或元素 aeration 的行程",
    ],
    [
        "a passage follows from the FV table and the area of the piston",
        "ein Durchlass folgt aus der FV-Tabelle und der Fläche des Kolbens",
        "un passage découle de la table FV et de la section du piston",
        "通道面积由 FV 表和活塞面积得出",
    ],
    [
        "fewer than two points of the FV table lie below the knee of this stroke",
        "weniger als zwei Punkte der FV-Tabelle liegen unter dem Knick dieses Hubs",
        "moins de deux points de la table FV se trouvent sous le coude de cette course",
        "此行程拐点以下的 FV 表点少于两个",
    ],
    [
        "the FV table of this stroke has no knee: no valve has opened",
        "die FV-Tabelle dieses Hubs hat keinen Knick: kein Ventil hat geöffnet",
        "la table FV de cette course n’a pas de coude : aucun clapet ne s’est ouvert",
        "此行程的 FV 表没有拐点：没有阀门开启",
    ],
    [
        "the bleed passes all of the flow",
        "der Bypass lässt den ganzen Strom durch",
        "la fuite calibrée laisse passer tout le débit",
        "节流孔通过全部流量",
    ],
    // What else is to know of a quantity.
    [
        "by the column in compression",
        "nach der Säule im Druck",
        "d’après la colonne en compression",
        "根据压缩时的油柱",
    ],
    [
        "the series spring less the eyes",
        "die Reihenfeder ohne die Augen",
        "le ressort en série sans les œillets",
        "串联弹簧减去吊环",
    ],
    [
        "a bound: the series spring holds eyes and oil; eye_stiffness_n_mm or an oil column in the model separates them",
        "eine Grenze: die Reihenfeder enthält Augen und Öl; eye_stiffness_n_mm oder eine Ölsäule im Modell trennt sie",
        "une borne : le ressort en série contient œillets et huile ; eye_stiffness_n_mm ou une colonne d’huile dans le modèle les sépare",
        "仅为界限：串联弹簧包含吊环和油液；eye_stiffness_n_mm 或模型中的油柱可将其分开",
    ],
    ["with the air in it", "mit der Luft darin", "avec l’air qu’elle contient", "含其中的空气"],
    [
        "no orifice shows beside the leak",
        "neben dem Leck zeigt sich keine Drossel",
        "aucun orifice n’apparaît à côté de la fuite",
        "除泄漏外未见节流孔",
    ],
    [
        "no leak shows beside the orifice",
        "neben der Drossel zeigt sich kein Leck",
        "aucune fuite n’apparaît à côté de l’orifice",
        "除节流孔外未见泄漏",
    ],
    [
        "opening at the largest force of the table",
        "Öffnung bei der größten Kraft der Tabelle",
        "ouverture au plus grand effort de la table",
        "表中最大力时的开口",
    ],
    [
        "uses {entries} as drawn, which the contradiction below puts in doubt",
        "verwendet {entries} nach Zeichnung; der Widerspruch unten stellt das in Frage",
        "utilise {entries} selon le plan, ce que la contradiction ci-dessous met en doute",
        "按图纸使用 {entries}，下述矛盾使其存疑",
    ],
    [
        "the fit had a prior of the dimensions for it",
        "die Anpassung hatte dafür einen Prior aus den Maßen",
        "l’ajustement avait pour cela un a priori tiré des dimensions",
        "拟合时对此使用了尺寸先验",
    ],
    // What contradicts.
    [
        "The {noun} of the model, {model}, is {ratio} times the {dimensions} that {facts} gives.",
        "{noun} des Modells: {model} sind das {ratio}-Fache der {dimensions}, die sich aus {facts} ergeben.",
        "{noun} du modèle : {model}, soit {ratio} fois les {dimensions} que donne {facts}.",
        "模型的{noun}为 {model}，是由 {facts} 得出的 {dimensions} 的 {ratio} 倍。",
    ],
    [
        "The {noun} of the model, {model}, is {ratio} times the {dimensions} that {facts} give.",
        "{noun} des Modells: {model} sind das {ratio}-Fache der {dimensions}, die {facts} ergeben.",
        "{noun} du modèle : {model}, soit {ratio} fois les {dimensions} que donnent {facts}.",
        "模型的{noun}为 {model}，是 {facts} 给出的 {dimensions} 的 {ratio} 倍。",
    ],
    [
        "{pressure} bar on a rod of {diameter} mm",
        "{pressure} bar auf einer Stange von {diameter} mm",
        "{pressure} bar sur une tige de {diameter} mm",
        "{pressure} bar 作用于 {diameter} mm 的活塞杆",
    ],
    // Quantities.
    ["gas pressure", "Gasdruck", "pression du gaz", "气体压力"],
    ["gas volume", "Gasvolumen", "volume de gaz", "气体体积"],
    ["effective modulus of the oil", "effektiver Modul des Öls", "module effectif de l’huile", "油液有效模量"],
    ["modulus of the oil", "Modul des Öls", "module de l’huile", "油液模量"],
    ["air content of the oil", "Luftgehalt des Öls", "teneur en air de l’huile", "油液含气量"],
    ["bleed area in rebound", "Bypassfläche im Zug", "section de fuite en détente", "复原节流面积"],
    ["bleed area in compression", "Bypassfläche im Druck", "section de fuite en compression", "压缩节流面积"],
    ["leak in rebound", "Leck im Zug", "fuite en détente", "复原泄漏"],
    ["leak in compression", "Leck im Druck", "fuite en compression", "压缩泄漏"],
    ["blow-off area in rebound", "Ventilfläche im Zug", "section de clapet en détente", "复原开阀面积"],
    ["blow-off area in compression", "Ventilfläche im Druck", "section de clapet en compression", "压缩开阀面积"],
    // Expected numbers.
    ["gas force", "Gaskraft", "effort de gaz", "气体力"],
    [
        "growth of the gas force with temperature",
        "Anstieg der Gaskraft mit der Temperatur",
        "croissance de l’effort de gaz avec la température",
        "气体力随温度的增长",
    ],
    ["gas stiffness", "Gassteifigkeit", "raideur du gaz", "气体刚度"],
    ["length of the gas column", "Länge der Gassäule", "longueur de la colonne de gaz", "气柱长度"],
    ["cavitation cap", "Kavitationsgrenze", "limite de cavitation", "空化上限"],
    ["stiffness of the oil column", "Steifigkeit der Ölsäule", "raideur de la colonne d’huile", "油柱刚度"],
    ["shortening of the oil column", "Verkürzung der Ölsäule", "raccourcissement de la colonne d’huile", "油柱缩短"],
    [
        "stiffness of the oil column in compression over that in rebound",
        "Steifigkeit der Ölsäule im Druck durch die im Zug",
        "raideur de la colonne d’huile en compression sur celle en détente",
        "油柱压缩与复原刚度之比",
    ],
    [
        "force that halves the air's stroke",
        "Kraft, die den Weg der Luft halbiert",
        "effort qui réduit de moitié la course de l’air",
        "使空气行程减半的力",
    ],
    ["stroke that the air yields", "Weg, den die Luft nachgibt", "course que cède l’air", "空气让出的行程"],
    ["series stiffness", "Reihensteifigkeit", "raideur en série", "串联刚度"],
    // Units and parameters in words.
    ["bar gauge", "bar Überdruck", "bar relatif", "bar（表压）"],
    ["% at 1.013 bar absolute", "% bei 1,013 bar absolut", "% à 1,013 bar absolu", "%（绝对压力 1.013 bar 时）"],
    [
        "fv_force at two slow speeds",
        "fv_force bei zwei langsamen Geschwindigkeiten",
        "fv_force à deux vitesses lentes",
        "两个低速下的 fv_force",
    ],
    [
        "fv_force at a fast speed",
        "fv_force bei einer schnellen Geschwindigkeit",
        "fv_force à une vitesse rapide",
        "高速下的 fv_force",
    ],
    [
        "oil_stiffness or aeration_stroke",
        "oil_stiffness oder aeration_stroke",
        "oil_stiffness ou aeration_stroke",
        "oil_stiffness 或 aeration_stroke",
    ],
];
