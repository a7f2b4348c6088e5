// SPDX-License-Identifier: Apache-2.0
// Programs as others write them: what they give, by sums made by hand, and what is said of what they do not give.
#include "trajectory/programs/reading/program_reader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "trajectory/files/trajectory_io.h"
#include "trajectory/programs/reading/program_readers.h"

namespace hapticell::trajectory {
namespace {

constexpr double kQuarter = 0.7071067811865476;

void expectPose(const Trajectory& motion, std::size_t i, const dvec3& p, const dquat& q) {
  ASSERT_LT(i, motion.size());
  EXPECT_LT(glm::length(motion[i].X_WT.p - p), 1e-9)
      << i << ": " << motion[i].X_WT.p.x << ' ' << motion[i].X_WT.p.y << ' ' << motion[i].X_WT.p.z;
  EXPECT_LT(distanceBetween(motion[i].X_WT, {motion[i].X_WT.p, q}).angle, 1e-8) << i;
}
const dquat kNoTurn(1, 0, 0, 0);

bool says(const std::vector<Text>& notes, const std::string& what) {
  for (const Text& note : notes)
    if (english(note).find(what) != std::string::npos) return true;
  return false;
}
std::string all(const std::vector<Text>& notes) {
  std::string text;
  for (const Text& note : notes) text += english(note) + '\n';
  return text;
}

const char* const kKrlSource = R"(&ACCESS RVP
&REL 12
&PARAM TEMPLATE = C:\KRC\Roboter\Template\vorgabe
DEF  glue( )
;FOLD INI
  ;FOLD BASISTECH INI
    GLOBAL INTERRUPT DECL 3 WHEN $STOPMESS==TRUE DO IR_STOPM ( )
    INTERRUPT ON 3
    BAS (#INITMOV,0 )
  ;ENDFOLD (BASISTECH INI)
;ENDFOLD (INI)
INT I
FRAME STEP
;FOLD PTP HOME  Vel= 100 % DEFAULT;%{PE}
$BWDSTART = FALSE
PDAT_ACT=PDEFAULT
FDAT_ACT=FHOME
BAS (#PTP_PARAMS,100 )
$H_POS=XHOME
PTP  XHOME
;ENDFOLD
$BASE = {X 1000,Y 0,Z 0,A 90,B 0,C 0}
$VEL.CP = 0.5
PTP XP1
LIN XP2 C_DIS
WAIT SEC 0.75
LIN_REL {Z 50} #TOOL
LIN_REL {X -10,Y 20}
STEP = {X 0,Y 0,Z 5,A 0,B 0,C 0}
FOR I = 1 TO 3
  LIN XP2:STEP
  STEP.Z = STEP.Z + 5*I
ENDFOR
$OUT[7] = TRUE
WAIT FOR $IN[3]
down(40)
PTP  XHOME
END
DEF down(H:IN)
REAL H
LIN {X 100,Y 0,Z 300}
LIN_REL {Z -10}
END
)";
const char* const kKrlData = R"(&ACCESS RVP
DEFDAT  GLUE
;FOLD EXTERNAL DECLARATIONS
EXT  BAS (BAS_COMMAND  :IN,REAL  :IN )
;ENDFOLD
DECL E6POS XP1={X 100.0,Y 0.0,Z 500.0,A 0.0,B 0.0,C 0.0,S 2,T 35,E1 0.0,E2 0.0,E3 0.0,E4 0.0,E5 0.0,E6 0.0}
DECL E6POS XP2={X 200.0,Y 0.0,Z 500.0,A 0.0,B 90.0,C 0.0,S 2,T 35,E1 0.0,E2 0.0,E3 0.0,E4 0.0,E5 0.0,E6 0.0}
DECL FDAT FP1={TOOL_NO 1,BASE_NO 1,IPO_FRAME #BASE,POINT2[] " "}
ENDDAT
)";

TEST(ProgramReader, KrlOfAPendantWithBaseRelativeMovesLoopsAndARoutine) {
  const auto read = readKrl({kKrlSource, kKrlData, ""}, {});
  ASSERT_TRUE(read) << read.error().message();
  const Trajectory& motion = read->trajectory;
  ASSERT_EQ(motion.size(), 9u) << all(read->notes);
  // The base turns by 90 deg about z and stands at x = 1 m: (x, y) becomes (1 - y, x).
  const dquat base(kQuarter, 0, 0, kQuarter), down = base * dquat(kQuarter, 0, kQuarter, 0);
  expectPose(motion, 0, {1.0, 0.1, 0.5}, base);
  expectPose(motion, 1, {1.0, 0.2, 0.5}, down);
  EXPECT_DOUBLE_EQ(motion[1].dwell, 0.75);
  expectPose(motion, 2, {1.0, 0.25, 0.5}, down);  // the tool's z is the base's x, B = 90
  expectPose(motion, 3, {0.98, 0.24, 0.5}, down);
  expectPose(motion, 4, {1.0, 0.205, 0.5}, down);
  expectPose(motion, 5, {1.0, 0.21, 0.5}, down);
  expectPose(motion, 6, {1.0, 0.22, 0.5}, down);
  expectPose(motion, 7, {1.0, 0.1, 0.3}, down);  // A, B, C stay
  expectPose(motion, 8, {1.0, 0.1, 0.29}, down);
  // 0.1 m at 0.5 m/s, or a quarter turn at 3 rad/s: the slower.
  EXPECT_NEAR(motion[1].t - motion[0].t, 0.5 * std::numbers::pi / 3.0, 1e-9);
  EXPECT_NEAR(motion[2].t - motion[1].t, 0.75 + 0.05 / 0.5, 1e-9);
  EXPECT_TRUE(says(read->notes, "Line 20: left out")) << all(read->notes);
  EXPECT_TRUE(says(read->notes, "xhome")) << all(read->notes);
  EXPECT_TRUE(says(read->notes, ": 7, 8, 34, 35")) << all(read->notes);
}

TEST(ProgramReader, KrlWithNewInlineFormsAndCircles) {
  const auto read = readKrl({R"(DEF c( )
SPTP {X 0,Y 0,Z 0,A 0,B 0,C 0}
SLIN {X 100,Y 0,Z 0,A 0,B 0,C 0} WITH $VEL=SVEL_CP(0.25,,LCPDAT1), $TOOL=STOOL2(FP1), $BASE=SBASE(0)
CIRC {X 0,Y 100,Z 0,A 0,B 0,C 0},{X -100,Y 0,Z 0,A 0,B 0,C 0}
CIRC {X 0,Y -100,Z 0},{X 100,Y 0,Z 0}, CA 90
END
)",
                             "", ""},
                            {});
  ASSERT_TRUE(read) << read.error().message();
  const Trajectory& motion = read->trajectory;
  double off = 0.0, longest = 0.0;
  for (std::size_t i = 1; i < motion.size(); ++i) {
    off = std::max(off, std::abs(glm::length(motion[i].X_WT.p) - 0.1));
    if (i > 1) longest = std::max(longest, glm::length(motion[i].X_WT.p - motion[i - 1].X_WT.p));
  }
  EXPECT_LT(off, 1e-12);
  EXPECT_LT(0.1 - std::sqrt(0.01 - 0.25 * longest * longest), 1e-4 + 1e-9) << "chords within 0.1 mm";
  expectPose(motion, motion.size() - 1, {0.0, -0.1, 0.0}, kNoTurn);
  EXPECT_NEAR(motion[2].t - motion[1].t, glm::length(motion[2].X_WT.p - motion[1].X_WT.p) / 0.25, 1e-6);
}

TEST(ProgramReader, RapidOfAStranger) {
  const auto read = readRapid(R"(%%%
  VERSION:1
  LANGUAGE:ENGLISH
%%%
MODULE MainModule
  PERS tooldata tGrip:=[TRUE,[[0,0,120],[1,0,0,0]],[1,[0,0,1],[1,0,0,0],0,0,0]];
  PERS wobjdata wTable:=[FALSE,TRUE,"",[[500,0,0],[1,0,0,0]],[[0,100,0],[0.707106781,0,0,0.707106781]]];
  CONST robtarget pHome:=[[100,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E+09]];
  LOCAL CONST robtarget pList{2}:=[[[0,0,100],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],
                                   [[50,0,100],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]];
  CONST jointtarget jRest:=[[0,0,0,0,90,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  VAR num n;
  VAR robtarget pick;
  PROC main()
    AccSet 80,80;
    MoveAbsJ jRest\NoEOffs,v1000,fine,tGrip;   ! at rest
    MoveJ pHome,v500,z10,tGrip;
    FOR i FROM 1 TO Dim(pList,1) DO
      MoveL Offs(pList{i},0,0,10*i),v100,z5,tGrip\WObj:=wTable;
    ENDFOR
    pick:=pList{1};
    pick.trans.z:=pick.trans.z-25;
    MoveL RelTool(pick,0,0,5\Rz:=90),v50,fine,tGrip\WObj:=wTable;
    SetDO doGrip,1;
    WaitTime 0.3;
    n:=0;
    WHILE n<2 DO
      Incr n;
      up 10*n;
    ENDWHILE
    IF n=2 MoveJ pHome,v500,fine,tGrip;
    TEST n
    CASE 1,5:
      Stop;
    CASE 2:
      MoveL Offs(pHome,1,2,3),v500,fine,tGrip;
    DEFAULT:
      Stop;
    ENDTEST
  ERROR
    RETRY;
  ENDPROC
  PROC up(num h)
    MoveL Offs(pick,0,0,h),v50,fine,tGrip\WObj:=wTable;
  ENDPROC
ENDMODULE
)",
                              {});
  ASSERT_TRUE(read) << read.error().message();
  const Trajectory& motion = read->trajectory;
  EXPECT_EQ(motion.name, "mainmodule");
  ASSERT_EQ(motion.size(), 8u) << all(read->notes);
  const dquat table(kQuarter, 0, 0, kQuarter);
  expectPose(motion, 0, {0.1, 0.0, 0.6}, {0, 0, 1, 0});
  expectPose(motion, 1, {0.5, 0.1, 0.11}, table);
  expectPose(motion, 2, {0.5, 0.15, 0.12}, table);
  expectPose(motion, 3, {0.5, 0.1, 0.08}, table * table);
  EXPECT_DOUBLE_EQ(motion[3].dwell, 0.3);
  expectPose(motion, 4, {0.5, 0.1, 0.085}, table);
  expectPose(motion, 5, {0.5, 0.1, 0.095}, table);
  expectPose(motion, 6, {0.1, 0.0, 0.6}, {0, 0, 1, 0});
  expectPose(motion, 7, {0.101, 0.002, 0.603}, {0, 0, 1, 0});
  EXPECT_TRUE(
      says(read->notes, "Line 16: left out, because it is before the first known target: a target given by joints"))
      << all(read->notes);
}

TEST(ProgramReader, JointTargetsByARobot) {
  ProgramReadOptions options;
  options.forward_kinematics = [](std::span<const double> q) { return Pose::translation({q[0], q[1], q[4]}); };
  options.joint_names = {"A1", "A2", "A3", "A4", "A5", "A6"};
  const std::string text =
      "MODULE m\nPROC main()\nMoveAbsJ [[0,0,0,0,90,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0;\n"
      "MoveAbsJ [[180,0,0,0,90,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0;\nENDPROC\nENDMODULE\n";
  const auto read = readRapid(text, options);
  ASSERT_TRUE(read) << read.error().message();
  ASSERT_EQ(read->trajectory.size(), 2u);
  EXPECT_EQ(read->trajectory.joint_names, options.joint_names);
  EXPECT_NEAR(read->trajectory[1].X_WT.p.x, std::numbers::pi, 1e-12);
  EXPECT_NEAR(read->trajectory.joints(1)[0], std::numbers::pi, 1e-12);
  const auto without = readRapid(text, {});
  ASSERT_FALSE(without);
  EXPECT_NE(without.error().message().find("--robot"), std::string::npos) << without.error().message();
}

TEST(ProgramReader, UrScriptOfAPendant) {
  const auto read = readUrScript(R"(def weld():
  set_tcp(p[0.0,0.0,0.1,0.0,0.0,0.0])
  set_payload(1.2)
  global Plane_1=p[0.5,0.0,0.0,0.0,0.0,1.570796326794897]
  global Waypoint_1_p=p[.3, -.2, .4, 0.0, 3.14159265358979, 0.0]
  global Waypoint_1_q=[0.1, -1.2, 1.3, 0.0, 0.5, 3.1]
  def approach(z):
    local over = Waypoint_1_p
    over[2] = over[2] + z
    movel(over, a=1.2, v=0.25)
  end
  while (True):
    $ 2 "Robot Program"
    movej(get_inverse_kin(Waypoint_1_p, qnear=Waypoint_1_q), a=1.3962634015954636, v=1.0471975511965976)
    movel(pose_trans(Plane_1, p[0.1,0,0.2,0,0,0]), 1.2, 0.1, 0, 0.002)
    approach(0.05)
    movep(pose_add(Waypoint_1_p, p[0,0,0.1,0,0,0]), a=1.2, v=0.25, r=0.05)
    sleep(0.5)
    set_digital_out(1, True)
    i = 0
    while i < 2:
      movel(p[0.3 + i*0.1, -0.2, 0.4, 0, 3.14159265358979, 0], v=0.1)
      i = i + 1
    end
    if i == 2:
      movec(p[0.45,-0.15,0.4,0,3.14159265358979,0], p[0.5,-0.2,0.4,0,3.14159265358979,0], a=1.2, v=0.1)
    else:
      movel(p[9,9,9,0,0,0])
    end
  end
end
)",
                                 {});
  ASSERT_TRUE(read) << read.error().message();
  const Trajectory& motion = read->trajectory;
  EXPECT_EQ(motion.name, "weld");
  ASSERT_GT(motion.size(), 7u) << all(read->notes);
  const dquat over(0, 0, 1, 0);
  expectPose(motion, 0, {0.3, -0.2, 0.4}, over);
  expectPose(motion, 1, {0.5, 0.1, 0.2}, {kQuarter, 0, 0, kQuarter});
  expectPose(motion, 2, {0.3, -0.2, 0.45}, over);
  expectPose(motion, 3, {0.3, -0.2, 0.5}, over);
  EXPECT_DOUBLE_EQ(motion[3].dwell, 0.5);
  expectPose(motion, 4, {0.3, -0.2, 0.4}, over);
  expectPose(motion, 5, {0.4, -0.2, 0.4}, over);
  for (std::size_t i = 6; i < motion.size(); ++i)
    EXPECT_NEAR(glm::length(motion[i].X_WT.p - dvec3(0.45, -0.2, 0.4)), 0.05, 1e-9);
  expectPose(motion, motion.size() - 1, {0.5, -0.2, 0.4}, over);
  EXPECT_TRUE(says(read->notes, "Line 12: an endless loop")) << all(read->notes);
}

const char* const kLs = R"(/PROG  PICK
/ATTR
OWNER       = MNEDITOR;
COMMENT     = "";
PROG_SIZE   = 500;
DEFAULT_GROUP   = 1,*,*,*,*;
CONTROL_CODE    = 00000000 00000000;
/APPL
/MN
   1:  UFRAME_NUM=0 ;
   2:  UTOOL_NUM=1 ;
   3:J P[1:home] 20% FINE    ;
   4:  ! a remark ;
   5:L P[2] 250mm/sec CNT50    ;
   6:L P[3] 60cm/min FINE ACC80    ;
   7:  WAIT    .50(sec) ;
   8:  R[1]=0    ;
   9:  LBL[1] ;
  10:L P[2] 100mm/sec FINE    ;
  11:  R[1]=R[1]+1    ;
  12:  IF R[1]<2,JMP LBL[1] ;
  13:  DO[1]=ON ;
  14:C P[3]
    :  P[4] 100mm/sec FINE    ;
  15:  CALL GRIP(1) ;
/POS
P[1:"home"]{
   GP1:
    UF : 0, UT : 1,     CONFIG : 'N U T, 0, 0, 0',
    X =   100.000  mm,  Y =     0.000  mm,  Z =   500.000  mm,
    W =   180.000 deg,  P =     0.000 deg,  R =     0.000 deg
};
P[2]{
   GP1:
    UF : 0, UT : 1,     CONFIG : 'F D B, 0, 0, -1',
    X =   200.000  mm,  Y =     0.000  mm,  Z =   500.000  mm,
    W =   180.000 deg,  P =     0.000 deg,  R =    90.000 deg,
    E1=   10.000  mm
   GP2:
    UF : 0, UT : 1,
    J1=     5.000 deg
};
P[3]{
   GP1:
    UF : 0, UT : 1,     CONFIG : 'N U T, 0, 0, 0',
    X =   250.000  mm,  Y =    50.000  mm,  Z =   500.000  mm,
    W =   180.000 deg,  P =     0.000 deg,  R =    90.000 deg
};
P[4]{
   GP1:
    UF : 0, UT : 1,     CONFIG : 'N U T, 0, 0, 0',
    X =   300.000  mm,  Y =     0.000  mm,  Z =   500.000  mm,
    W =   180.000 deg,  P =     0.000 deg,  R =    90.000 deg
};
/END
)";

TEST(ProgramReader, FanucOfAPendant) {
  const auto read = readFanuc(kLs, {});
  ASSERT_TRUE(read) << read.error().message();
  const Trajectory& motion = read->trajectory;
  EXPECT_EQ(motion.name, "PICK");
  ASSERT_GT(motion.size(), 6u);
  const dquat flipped(0, 1, 0, 0), turned = dquat(kQuarter, 0, 0, kQuarter) * flipped;
  expectPose(motion, 0, {0.1, 0.0, 0.5}, flipped);
  expectPose(motion, 1, {0.2, 0.0, 0.5}, turned);
  expectPose(motion, 2, {0.25, 0.05, 0.5}, turned);
  EXPECT_DOUBLE_EQ(motion[2].dwell, 0.5);
  EXPECT_NEAR(motion[2].t - motion[1].t, std::hypot(0.05, 0.05) / 0.01, 1e-9) << "60 cm/min";
  expectPose(motion, 3, {0.2, 0.0, 0.5}, turned);
  expectPose(motion, 4, {0.2, 0.0, 0.5}, turned);  // once more by the jump
  for (std::size_t i = 5; i < motion.size(); ++i)
    EXPECT_NEAR(glm::length(motion[i].X_WT.p - dvec3(0.25, 0.0, 0.5)), 0.05, 1e-9);
  expectPose(motion, motion.size() - 1, {0.3, 0.0, 0.5}, turned);
  EXPECT_TRUE(says(read->notes, "CALL GRIP(1)")) << all(read->notes);
  EXPECT_TRUE(says(read->notes, "group 1")) << all(read->notes);
}

TEST(ProgramReader, FanucWithPositionRegistersAndLinesWithoutNumbers) {
  const auto read = readFanuc(R"(/PROG layer
/MN
:SR[30]=60.0;
1: L P[1] 240cm/min CNT100 COORD ;
: Arc Start[1];
2: PR[2:TMP]=P[1] ;
3: PR[2,3:TMP]=PR[2,3:TMP]-R[21:DOWN] ;
4: R[21:DOWN]=25 ;
5: PR[3]=P[1] ;
6: PR[3,3]=PR[3,3]-R[21] ;
7: PR[3,6]=90 ;
8: L PR[3:NAME] 100mm/sec FINE ;
9: R[1]=2 ;
10: IF R[1]=2 AND R[21]>20,JMP LBL[7] ;
11: L P[1] 100mm/sec FINE ;
12: LBL[7:END] ;
/POS
P[1]{ GP1: UF : 3, UT : 1, CONFIG : 'L, 0, 0, 0',
 X = 400.0 mm, Y = 0.0 mm, Z = 100.0 mm, W = 0.0 deg, P = 0.0 deg, R = 0.0 deg };
/END
)",
                              {});
  ASSERT_TRUE(read) << read.error().message();
  ASSERT_EQ(read->trajectory.size(), 2u) << all(read->notes);
  expectPose(read->trajectory, 0, {0.4, 0.0, 0.1}, kNoTurn);
  expectPose(read->trajectory, 1, {0.4, 0.0, 0.075}, {kQuarter, 0, 0, kQuarter});
  EXPECT_TRUE(says(read->notes, "Poses are relative to the user frame 3")) << all(read->notes);
  EXPECT_TRUE(says(read->notes, "COORD")) << all(read->notes);
}

TEST(ProgramReader, MotomanJob) {
  const auto read = readInform(R"(/JOB
//NAME CUT
//POS
///NPOS 4,0,0,0,0,0
///TOOL 0
///POSTYPE PULSE
///PULSE
C00000=100,200,300,0,0,0
///POSTYPE BASE
///RECTAN
///RCONF 1,0,0,0,0,0,0,0
C00001=500.000,0.000,400.000,180.0000,0.0000,0.0000
C00002=550.000,50.000,400.000,180.0000,0.0000,0.0000
C00003=600.000,0.000,400.000,180.0000,0.0000,90.0000
//INST
///DATE 2020/01/01 10:00
///ATTR SC,RW
///GROUP1 RB1
NOP
'remark
MOVJ C00000 VJ=10.00
MOVL C00001 V=50.0
TIMER T=1.50
MOVC C00001 V=50.0
MOVC C00002 V=50.0
MOVC C00003 V=50.0
DOUT OT#(1) ON
END
)",
                               {});
  ASSERT_TRUE(read) << read.error().message();
  const Trajectory& motion = read->trajectory;
  EXPECT_EQ(motion.name, "CUT");
  expectPose(motion, 0, {0.5, 0.0, 0.4}, {0, 1, 0, 0});
  EXPECT_DOUBLE_EQ(motion[0].dwell, 1.5);
  ASSERT_GT(motion.size(), 3u);
  for (std::size_t i = 0; i < motion.size(); ++i)
    EXPECT_NEAR(glm::length(motion[i].X_WT.p - dvec3(0.55, 0.0, 0.4)), 0.05, 1e-9);
  expectPose(motion, motion.size() - 1, {0.6, 0.0, 0.4}, dquat(kQuarter, 0, 0, kQuarter) * dquat(0, 1, 0, 0));
  EXPECT_TRUE(says(read->notes, "in pulses")) << all(read->notes);
}

/// What makes another motion of it than the controller would is an error with its line.
TEST(ProgramReader, WhatItCannotKnowIsRefusedWithItsLine) {
  struct Case {
    const char* what;
    Expected<ReadProgram> read;
    const char* line;
  };
  const std::string pose = "{X 1,Y 2,Z 3,A 0,B 0,C 0}";
  const std::string target = "[[1,2,3],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]";
  const std::string rapid = "MODULE m\nPROC main()\nMoveL " + target + ",v10,fine,tool0;\n";
  const std::vector<Case> cases{
      {"a target in the middle",
       readKrl({"DEF a( )\nPTP " + pose + "\nLIN XSEARCH\nLIN " + pose + "\nEND\n", "", ""}, {}), "line 3"},
      {"a branch by an input",
       readKrl({"DEF a( )\nPTP " + pose + "\nIF $IN[1] THEN\nLIN " + pose + "\nENDIF\nEND\n", "", ""}, {}), "line 3"},
      {"a jump", readKrl({"DEF a( )\nPTP " + pose + "\nGOTO x\nEND\n", "", ""}, {}), "line 3"},
      {"two bases",
       readKrl({"DEF a( )\nBAS(#BASE,1)\nPTP " + pose + "\nBAS(#BASE,2)\nLIN " + pose + "\nEND\n", "", ""}, {}),
       "line 5"},
      {"no end", readKrl({"DEF a( )\nPTP " + pose + "\n", "", ""}, {}), "line 2"},
      {"a displacement", readRapid(rapid + "PDispOn p1,tool0;\nENDPROC\nENDMODULE\n", {}), "line 4"},
      {"an unknown target",
       readRapid(rapid + "MoveL pX,v10,fine,tool0;\nMoveL " + target + ",v10,fine,tool0;\nENDPROC\nENDMODULE\n", {}),
       "line 4"},
      {"two work objects",
       readRapid(rapid + "MoveL " + target + ",v10,fine,tool0\\WObj:=w2;\nENDPROC\nENDMODULE\n", {}), "line 4"},
      {"servoing", readUrScript("def a():\n  movel(p[0,0,0,0,0,0])\n  servoj([0,0,0,0,0,0])\nend\n", {}), "line 3"},
      {"joints in the middle", readUrScript("movel(p[0,0,0,0,0,0])\nmovej([0,0,0,0,0,0])\nmovel(p[0,0,0,0,0,0])\n", {}),
       "line 2"},
      {"a target by a sensor",
       readUrScript("movel(p[0,0,0,0,0,0])\nx = socket_read_ascii_float(6)\nmovel(x)\nmovel(p[0,0,0,0,0,0])\n", {}),
       "line 3"},
      {"an offset", readFanuc("/PROG A\n/MN\n 1:L P[1] 10mm/sec FINE Offset,PR[1] ;\n/POS\n/END\n", {}), "line 3"},
      {"another user frame",
       readFanuc(
           "/PROG A\n/MN\n 1:L P[1] 10mm/sec FINE ;\n 2:L P[2] 10mm/sec FINE ;\n/POS\n"
           "P[1]{\nGP1:\nUF : 1, UT : 1,\nX = 1 mm, Y = 1 mm, Z = 1 mm, W = 0 deg, P = 0 deg, R = 0 deg\n};\n"
           "P[2]{\nGP1:\nUF : 2, UT : 1,\nX = 1 mm, Y = 1 mm, Z = 1 mm, W = 0 deg, P = 0 deg, R = 0 deg\n};\n/END\n",
           {}),
       "line 4"},
      {"an empty program", readUrScript("# nothing\n", {}), "no moves"},
      {"endless calls", readUrScript("def a():\n  movel(p[0,0,0,0,0,0])\n  a()\nend\na()\n", {}), "line 3"},
  };
  for (const Case& c : cases) {
    ASSERT_FALSE(c.read) << c.what << ": " << all(c.read->notes);
    EXPECT_NE(c.read.error().message().find(c.line), std::string::npos) << c.what << ": " << c.read.error().message();
  }
}

TEST(ProgramReader, WhatIsNotUnderstoodIsReported) {
  const auto read = readRapid(
      "MODULE m\nPROC main()\nMoveL [[1,2,3],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v10,fine,tool0;\n"
      "GlueGun on,7;\nENDPROC\nENDMODULE\n",
      {});
  ASSERT_TRUE(read) << read.error().message();
  EXPECT_TRUE(says(read->notes, "Line 4: 'gluegun on,7'")) << all(read->notes);
}

TEST(ProgramReader, FilesAreFoundByTheirEndingsAndKrlsPointsBesideThem) {
  const auto folder = std::filesystem::temp_directory_path() / "hapticell-program-reader";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "Glue.SRC") << kKrlSource;
  const auto alone = readTrajectory(folder / "Glue.SRC");
  ASSERT_FALSE(alone) << "no targets without the .dat";
  EXPECT_NE(alone.error().message().find("Glue.SRC, line"), std::string::npos) << alone.error().message();
  std::ofstream(folder / "glue.dat") << kKrlData;
  std::ofstream(folder / "$config.dat")
      << "DEFDAT $CONFIG PUBLIC\nDECL GLOBAL FDAT FHOME={TOOL_NO 0,BASE_NO 0}\nENDDAT\n";
  for (const char* name : {"Glue.SRC", "glue.dat"}) {
    std::vector<Text> notes;
    const auto read = readTrajectory(folder / name, &notes);
    ASSERT_TRUE(read) << read.error().message();
    EXPECT_EQ(read->size(), 9u);
    EXPECT_EQ(read->moved, "tcp");
    EXPECT_FALSE(notes.empty());
  }
  std::ofstream(folder / "pick.LS") << kLs;
  EXPECT_TRUE(readTrajectory(folder / "pick.LS"));
  std::ofstream(folder / "pick.tp.ls", std::ios::binary) << std::string("\x01\x00\x02", 3);
  EXPECT_FALSE(readTrajectory(folder / "pick.tp.ls"));
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace hapticell::trajectory
